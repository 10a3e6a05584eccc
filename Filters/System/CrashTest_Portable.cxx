// SPDX-License-Identifier: BSD-3-Clause
#include "System/CrashTest.h"

bool Crashes(const std::function<void()>&)
{
  return false;
}
