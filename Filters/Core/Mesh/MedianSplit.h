// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How trees over facets are split.
 */
#ifndef carving_MedianSplit_h
#define carving_MedianSplit_h

#include "Core/Mesh/Mesh.h"

#include <algorithm>

namespace carving
{

/**
 * Reorders the items so that those below the median of an axis come first, and returns the first of
 * the others. The axis is the one on which `extent` is longest. `centerOf` and `indexOf` give the
 * point and the number of an item; the number breaks ties, so that the order never depends on the
 * library.
 */
template <class Iterator, class CenterOf, class IndexOf>
Iterator SplitAtMedian(
  Iterator first, Iterator last, const Point& extent, CenterOf&& centerOf, IndexOf&& indexOf)
{
  const auto axis = std::max_element(extent.begin(), extent.end()) - extent.begin();
  const Iterator middle = first + (last - first) / 2;
  std::nth_element(first, middle, last,
    [&](const auto& a, const auto& b)
    {
      const double x = centerOf(a)[axis], y = centerOf(b)[axis];
      return x != y ? x < y : indexOf(a) < indexOf(b);
    });
  return middle;
}

} // namespace carving

#endif
