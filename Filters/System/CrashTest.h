// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Work of other libraries that may crash.
 */
#ifndef CrashTest_h
#define CrashTest_h

#include <functional>

/**
 * Whether some work crashes, or ends the process otherwise. On Linux, a copy of this process does
 * the work, with no effect on this process. Elsewhere, nothing is tried, and the answer is no.
 */
bool Crashes(const std::function<void()>& work);

#endif
