// SPDX-License-Identifier: BSD-3-Clause
#include "Process/HelperCommand.h"

void SetHelperCommand(vtksysProcess* process, const std::string& program, const TemporaryFile& job,
  const TemporaryFile& reply)
{
  const char* command[] = { program.c_str(), nullptr };
  vtksysProcess_SetCommand(process, command);
  vtksysProcess_SetPipeFile(process, vtksysProcess_Pipe_STDIN, job.GetPath().c_str());
  vtksysProcess_SetPipeFile(process, vtksysProcess_Pipe_STDOUT, reply.GetPath().c_str());
}
