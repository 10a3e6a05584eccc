// SPDX-License-Identifier: BSD-3-Clause
#include "Process/HelperCommand.h"

void SetHelperCommand(vtksysProcess* process, const std::string& program, const TemporaryFile& job,
  const TemporaryFile& reply)
{
  const std::string jobPath = job.GetPath(), replyPath = reply.GetPath();
  const char* command[] = { program.c_str(), jobPath.c_str(), replyPath.c_str(), nullptr };
  vtksysProcess_SetCommand(process, command);
}
