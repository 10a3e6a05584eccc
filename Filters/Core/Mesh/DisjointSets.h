// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Union-find.
 */
#ifndef carving_DisjointSets_h
#define carving_DisjointSets_h

#include "Core/Mesh/LargePages.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace carving
{

/** A partition of the numbers below `size`, initially into single numbers. */
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size)
    : Parent(MakeLarge<int>(size))
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  /** The smallest member of a's set. */
  int Find(int a)
  {
    while (this->Parent[a] != a)
    {
      a = this->Parent[a] = this->Parent[this->Parent[a]];
    }
    return a;
  }

  void Unite(int a, int b)
  {
    const auto [lower, upper] = std::minmax({ this->Find(a), this->Find(b) });
    this->Parent[upper] = lower;
  }

private:
  std::vector<int> Parent;
};

} // namespace carving

#endif
