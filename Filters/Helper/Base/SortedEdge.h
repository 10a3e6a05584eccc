// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_SortedEdge_h
#define carving_SortedEdge_h

#include <algorithm>
#include <array>

namespace carving::helper
{

/** The ends of an edge in ascending order: the same for both directions. */
inline std::array<int, 2> SortedEdge(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

} // namespace carving::helper

#endif
