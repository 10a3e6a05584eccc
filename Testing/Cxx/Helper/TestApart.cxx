// SPDX-License-Identifier: BSD-3-Clause
#include "Apart.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <unistd.h>
#include <vector>

// Work that succeeds says nothing; what it leaves as message arrives.
TEST(RunApart, SaysNothingOfSuccess)
{
  Messages messages;
  EXPECT_EQ(RunApart({},
              [&]
              {
                messages.Add("one");
                messages.Add("two");
                return true;
              }),
    "");
  EXPECT_EQ(messages.Get(), "one\ntwo\n");
}

// What it changes here stays as it was.
TEST(RunApart, ChangesNothingHere)
{
  int number = 1;
  EXPECT_EQ(RunApart({},
              [&]
              {
                number = 2;
                return false;
              }),
    "failed");
  EXPECT_EQ(number, 1);
}

// A crash is a sentence, and this process goes on.
TEST(RunApart, SurvivesACrash)
{
  const std::string end = RunApart({},
    []
    {
      std::abort();
      return true;
    });
  EXPECT_EQ(end, "crashed (Aborted)");
}

// What hangs is ended when its time is over.
TEST(RunApart, EndsWhatHangs)
{
  const std::string end = RunApart({ 0.2, 0.0 },
    []
    {
      for (;;)
      {
        pause();
      }
      return true;
    });
  EXPECT_EQ(end.find("took longer"), 0u) << end;
}

#ifndef __SANITIZE_ADDRESS__ // which reserves more address space than any limit
// What wants more memory than it may have fails, and this is said.
TEST(RunApart, LimitsMemory)
{
  const std::string end = RunApart({ 0.0, 256.0 },
    []
    {
      const std::vector<char> much(std::size_t(1) << 30, 1);
      return much.size() > 1;
    });
  EXPECT_EQ(end, "ran out of memory");
}
#endif

// Processes that run apart can run others apart, whose messages arrive here too.
TEST(RunApart, CanBeNested)
{
  Messages messages;
  const std::string end = RunApart({},
    [&]
    {
      messages.Add(RunApart({},
        []
        {
          std::abort();
          return true;
        }));
      return true;
    });
  EXPECT_EQ(end, "");
  EXPECT_EQ(messages.Get(), "crashed (Aborted)\n");
}
