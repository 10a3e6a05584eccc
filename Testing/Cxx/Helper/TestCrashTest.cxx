// SPDX-License-Identifier: BSD-3-Clause
// Work that is tried in a copy of the process, on Linux.
#include "System/CrashTest.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

// Work that ends the process by a signal, an exception or an exit crashes; other work does not.
TEST(CrashTest, TellsHowWorkEnds)
{
  EXPECT_FALSE(Crashes([] {}));
  EXPECT_TRUE(Crashes([] { std::raise(SIGKILL); }));
  EXPECT_TRUE(Crashes([] { std::abort(); }));
  EXPECT_TRUE(Crashes([] { std::_Exit(1); }));
  EXPECT_TRUE(Crashes([] { throw 1; }));
}

// The same is told where SIGCHLD is ignored, as some programs have it for those that they start.
TEST(CrashTest, TellsHowWorkEndsWithoutSignals)
{
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_FALSE(Crashes([] {}));
  EXPECT_TRUE(Crashes([] { std::abort(); }));
  std::signal(SIGCHLD, before);
}

// What the work changes, it changes in the copy alone.
TEST(CrashTest, LeavesNoTrace)
{
  int number = 1;
  EXPECT_FALSE(Crashes([&number] { number = 2; }));
  EXPECT_EQ(number, 1);
}
