// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/ForEach.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

using namespace carving;

// However many threads there are, every number is visited once.
TEST(ForEach, VisitsEveryNumberOnce)
{
  for (const int threads : { 0, 1, 2, 7, 100 })
  {
    for (const int count : { 0, 1, 2, 50 })
    {
      std::vector<std::atomic<int>> visits(count);
      ForEach(threads, count, [&](int i) { ++visits[i]; });
      for (const auto& number : visits)
      {
        EXPECT_EQ(number, 1);
      }
    }
  }
}

// An exception of any thread arrives.
TEST(ForEach, PassesOnExceptions)
{
  for (const int threads : { 1, 3 })
  {
    const auto throws = [](int i)
    {
      if (i == 5)
      {
        throw std::runtime_error("five");
      }
    };
    EXPECT_THROW(ForEach(threads, 10, throws), std::runtime_error);
  }
}
