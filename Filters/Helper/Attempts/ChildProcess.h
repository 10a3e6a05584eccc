// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Work that may crash, hang or run out of memory, done in a process of its own.
 */
#ifndef carving_ChildProcess_h
#define carving_ChildProcess_h

#include "Helper/Base/Ending.h"

#include <functional>
#include <string>

/** 0: no limit. */
struct Limits
{
  double Seconds = 0.0;          ///< by the clock
  double ProcessorSeconds = 0.0; ///< its own and those of what it runs apart in turn
  double Mebibytes = 0.0;
};

/**
 * Forks, and calls `work` in the child, which sees all that there is here and changes none of it. The
 * mistake is empty if `work` returned true, "failed" if it returned false, else what ended it. What it has
 * added to `Messages` is kept. A process whose own processor time is limited gives a child no more than what
 * is left of it.
 */
Ending RunInChildProcess(const Limits& limits, const std::function<bool()>& work);

/** Lets this process, and those that it forks, have no more than this; 0: no limit. */
void LimitMemory(double mebibytes);

#endif
