// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hints that keep loops over all cells from waiting for memory. They are always inlined, since a
 * compiler may drop calls of functions that seem to do nothing.
 */
#ifndef carving_Fetch_h
#define carving_Fetch_h

#include "Core/Mesh/Mesh.h"

#include <algorithm>
#include <vector>

namespace carving
{

/** Has the processor fetch what each array has of a cell's neighbors, which are all over memory. */
template <int D, class... Values>
[[gnu::always_inline]] inline void FetchNeighbors(
  const Decomposition<D>& mesh, int cell, const std::vector<Values>&... arrays)
{
  for (const int neighbor : mesh.Neighbors[cell])
  {
    (__builtin_prefetch(&arrays[std::max(neighbor, 0)]), ...);
  }
}

/** The same in a loop over all cells that has come to `cell`, for one that is about to come. */
template <int D, class... Values>
[[gnu::always_inline]] inline void FetchAhead(
  const Decomposition<D>& mesh, int cell, const std::vector<Values>&... arrays)
{
  constexpr int ahead = 12;
  const int last = static_cast<int>(mesh.Neighbors.size()) - 1;
  FetchNeighbors(mesh, std::min(cell + ahead, last), arrays...);
}

} // namespace carving

#endif
