// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Runs work that may crash, hang or run out of memory in a child process.
 */
#ifndef carving_ChildProcess_h
#define carving_ChildProcess_h

#include "Helper/Base/Ending.h"

#include <functional>
#include <string>

namespace carving::helper
{

/** The limits of a process; 0: no limit. */
struct Limits
{
  double Seconds = 0.0;          ///< by the clock
  double ProcessorSeconds = 0.0; ///< of the process and its own child processes together
  double Mebibytes = 0.0;
};

/**
 * Forks and calls `work` in the child. The child sees the memory of this process, and its changes
 * are lost, except for lines added to `Messages`. The returned mistake is empty if `work` returns
 * true, "failed" if `work` returns false, and otherwise says how the child ended.
 *
 * If the processor time of this process is limited, the child gets at most the remaining time, and
 * the time that the child takes is subtracted from it.
 */
Ending RunInChildProcess(const Limits& limits, const std::function<bool()>& work);

/** Limits the memory of this process and of processes that it forks; 0: no limit. */
void LimitMemory(double mebibytes);

} // namespace carving::helper

#endif
