// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs the helper program as a child process: whatever happens to it, the host lives.
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

/** Called with a stage and the fraction of it that is done; returns false to abort. */
using Observer = std::function<bool(carving::Stage, double)>;

/**
 * Sends the job to carving-helper and reads its reply. The program is the one that the environment
 * variable TOPOLOGYCARVING_HELPER names, else the one that was built or installed with this library.
 *
 * `observer` is called as work proceeds and at least ten times a second; when it returns false the
 * child is killed at once. On Failure `error` says in words what happened. No file is written.
 */
VTKTOPOLOGYCARVING_EXPORT Outcome Run(
  const carving::Job& job, carving::Reply& reply, const Observer& observer, std::string& error);

} // namespace HelperProcess

#endif
