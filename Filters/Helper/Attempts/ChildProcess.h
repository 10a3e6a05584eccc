// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Runs work that may crash, hang or run out of memory in a child process.
 */
#ifndef carving_ChildProcess_h
#define carving_ChildProcess_h

#include "Helper/Base/Ending.h"

#include <functional>
#include <iosfwd>
#include <string>

namespace carving::helper
{

/** The limits of a process; 0: no limit. */
struct Limits
{
  double Seconds = 0.0;          ///< by the clock
  double ProcessorSeconds = 0.0; ///< of the process and its own child processes together
  double Mebibytes = 0.0;        ///< on Linux alone; elsewhere without effect
};

/** Work for a child process. */
struct Work
{
  /** Does the work, in the child process. */
  std::function<bool()> Do;
  /** Writes all that a process needs to do the work if it does not see this one's memory. */
  std::function<void(std::ostream&)> Write;
};

/**
 * Does the work in a child process. The returned mistake is empty if the work returns true,
 * `WorkFailed` if it returns false, and otherwise says how the child ended. Changes that the work
 * makes to memory are lost, except for lines added to `Messages`.
 *
 * On Linux, the child is a fork of this process and calls `work.Do`. Elsewhere, it is another run
 * of this program, which reads what `work.Write` has written.
 *
 * If the processor time of this process is limited, the child gets at most the remaining time, and
 * the time that the child takes is subtracted from it. Where children are no forks, one that
 * crashes, or that a limit by the clock ends, counts with its time by the clock.
 *
 * This process calls `meanwhile` beside the child, even if no child can be started. If that returns
 * false, the child is killed unless it has ended, its time is not subtracted, and the mistake is
 * `NotWanted`. If it throws, the child is killed, too, and the exception passed on.
 */
Ending RunInChildProcess(
  const Limits& limits, const Work& work, const std::function<bool()>& meanwhile = {});

/** The mistake of a child whose work returned false. */
constexpr const char* WorkFailed = "failed";

/** The mistake of a child that is not wanted any more. */
constexpr const char* NotWanted = "is not wanted";

/**
 * To be called first in a program that runs child processes, with the arguments of its function
 * main. A limit on the size of files then makes writing fail instead of ending the program. On
 * Linux, the program ends with its parent.
 *
 * Elsewhere, if this run of the program is a child process, the function calls `resume` with what
 * `Work::Write` has written, and ends the process. Temporary files are made, and vanish; their
 * names begin with `stem`, a path that no other program uses.
 */
void BeginProgram(int argc, char* argv[], const std::string& stem,
  const std::function<bool(std::istream&)>& resume);

/** Whether child processes end with this process, however this one ends. */
bool ChildProcessesEndWithThis();

/** Limits the memory of this process and of its child processes, on Linux alone; 0: no limit. */
void LimitMemory(double mebibytes);

} // namespace carving::helper

#endif
