// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Large pages of memory.
 */
#include "Core/Mesh/LargePages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

using namespace carving;

namespace
{

/** What the system says of the memory at an address; empty if nothing. */
std::string FlagsOf(const void* memory)
{
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  std::ifstream maps("/proc/self/smaps");
  std::string line;
  bool isHere = false;
  while (std::getline(maps, line))
  {
    std::uintptr_t first = 0, last = 0;
    char dash = 0;
    std::istringstream range(line);
    if (range >> std::hex >> first >> dash >> last && dash == '-')
    {
      isHere = first <= address && address < last;
    }
    else if (isHere && line.rfind("VmFlags:", 0) == 0)
    {
      return line + " ";
    }
  }
  return {};
}

} // namespace

// An array has its values whether or not it is large enough for large pages.
TEST(LargePages, HoldArrays)
{
  for (const std::size_t count : { 0u, 1u, 1000u, 1000000u })
  {
    const std::vector<int> values = MakeLarge(count, 7);
    EXPECT_EQ(values.size(), count);
    EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](int value) { return value == 7; }));
  }
}

// The system knows that the pages of a large array are to be large.
TEST(LargePages, AreAskedFor)
{
#ifdef TOPOLOGYCARVING_PORTABLE
  GTEST_SKIP() << "the portable build asks for nothing";
#endif
  const std::vector<int> values = MakeLarge<int>(4000000);
  const std::string flags = FlagsOf(values.data() + values.size() / 2);
  if (flags.empty() || !std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled"))
  {
    GTEST_SKIP() << "the system has no large pages, or does not say";
  }
  EXPECT_NE(flags.find(" hg "), std::string::npos);
}
