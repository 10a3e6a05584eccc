// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadCarefully_h
#define ReadCarefully_h

#include "System/CrashTest.h"

#include <string>

/**
 * For VTK's readers that crash on many broken files. `read` returns an empty string, or an error.
 * On Linux, `read` is called in a copy of this process first.
 */
template <class Read>
std::string ReadCarefully(const Read& read)
{
  return Crashes([&read] { read(); }) ? "VTK's reader crashes on it: it is broken, or ends early"
                                      : read();
}

#endif
