// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Work on several threads.
 */
#ifndef carving_ForEach_h
#define carving_ForEach_h

#include <algorithm>
#include <atomic>
#include <future>
#include <vector>

namespace carving
{

/**
 * Calls `work(i)` for every i below `count`, with at most `threads` calls at a time, this thread's
 * included. Calls begin in the order of i. Returns when all have ended; then an exception of one of
 * them is thrown.
 */
template <class Work>
void ForEach(int threads, int count, const Work& work)
{
  std::atomic<int> next{ 0 };
  const auto run = [&]
  {
    for (int i = next++; i < count; i = next++)
    {
      work(i);
    }
  };
  std::vector<std::future<void>> others;
  for (int thread = 1; thread < std::min(threads, count); ++thread)
  {
    others.push_back(std::async(std::launch::async | std::launch::deferred, run));
  }
  run();
  for (std::future<void>& other : others)
  {
    other.get();
  }
}

} // namespace carving

#endif
