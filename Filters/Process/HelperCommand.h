// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How the helper program gets its job and returns its reply.
 */
#ifndef HelperCommand_h
#define HelperCommand_h

#include "System/TemporaryFile.h"
#include "vtksys/Process.h"

/**
 * Has a process, which is not yet started, run the helper program on a job that has been written.
 * On Linux, the files are standard input and output. Elsewhere, the program gets their paths as
 * arguments.
 */
void SetHelperCommand(vtksysProcess* process, const std::string& program, const TemporaryFile& job,
  const TemporaryFile& reply);

#endif
