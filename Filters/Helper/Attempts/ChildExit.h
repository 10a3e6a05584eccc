// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * How child processes end, on every system.
 */
#ifndef carving_ChildExit_h
#define carving_ChildExit_h

#include "Helper/Attempts/ChildProcess.h"

#include <cstdio>
#include <functional>
#include <string>

namespace carving::helper
{

/** Exit codes of child processes whose work returned false or ran out of memory. */
constexpr int ExitFailed = 3;
constexpr int ExitOutOfMemory = 4;

inline Ending TookTooLong(double seconds, const char* ofWhat)
{
  char text[64];
  std::snprintf(text, sizeof(text), "took longer than %g s%s", seconds, ofWhat);
  return { text, true };
}

inline Ending DescribeExit(int code)
{
  switch (code)
  {
    case 0:
      return {};
    case ExitOutOfMemory:
      return { "ran out of memory", true };
    default:
      return { WorkFailed };
  }
}

/** Where no child can be started, does what should have been done beside it. */
inline Ending EndWithoutChild(const std::function<bool()>& meanwhile, const std::string& problem)
{
  return !meanwhile || meanwhile() ? Ending{ "could not be started: " + problem, true }
                                   : Ending{ NotWanted };
}

} // namespace carving::helper

#endif
