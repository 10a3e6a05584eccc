// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs the helper program as a child process, so that no crash of it affects the host.
 */
#ifndef HelperProcess_h
#define HelperProcess_h

#include "Core/Protocol/Protocol.h"
#include "vtkTopologyCarvingModule.h" // for export macro

#include <functional>
#include <string>

namespace HelperProcess
{

enum class Outcome
{
  Success,
  Failure,
  Aborted
};

/** Is called with the progress of the work. Returns false to abort. */
using Observer = std::function<bool(const carving::WorkProgress&)>;

/**
 * Sends the job to carving-helper and reads its reply. The environment variable
 * TOPOLOGYCARVING_HELPER names the program; without it, the program is the one that was built or
 * installed with this library.
 *
 * `observer` is called with every progress of the work, and at least ten times a second. If it
 * returns false, the child is killed at once. After a Failure, `error` is a sentence on the reason.
 * No file is written.
 */
VTKTOPOLOGYCARVING_EXPORT Outcome Run(
  const carving::Job& job, carving::Reply& reply, const Observer& observer, std::string& error);

} // namespace HelperProcess

#endif
