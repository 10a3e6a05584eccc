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

/** The edges of a tetrahedron with these corners. */
inline std::array<std::array<int, 2>, 6> EdgesOf(const std::array<int, 4>& c)
{
  return { SortedEdge(c[0], c[1]), SortedEdge(c[0], c[2]), SortedEdge(c[0], c[3]),
    SortedEdge(c[1], c[2]), SortedEdge(c[1], c[3]), SortedEdge(c[2], c[3]) };
}

} // namespace carving::helper

#endif
