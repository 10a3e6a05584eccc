// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Prefetching for loops over all cells, whose neighbors are scattered in memory. The functions are
 * always inlined: a compiler may drop calls of functions without visible effects.
 */
#ifndef carving_Fetch_h
#define carving_Fetch_h

#include "Core/Mesh/Mesh.h"

#include <algorithm>
#include <vector>

namespace carving
{

/** Prefetches the entries of a cell's neighbors in each array. */
template <int D, class... Values>
[[gnu::always_inline]] inline void FetchNeighbors(
  const Decomposition<D>& mesh, int cell, const std::vector<Values>&... arrays)
{
  for (const int neighbor : mesh.Neighbors[cell])
  {
    (__builtin_prefetch(&arrays[std::max(neighbor, 0)]), ...);
  }
}

/**
 * In a loop over all cells that has reached `cell`: does the same for a cell some iterations ahead.
 */
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
