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

/** Asks the processor to read from an address ahead of time; where the compiler cannot, nothing. */
[[gnu::always_inline]] inline void Prefetch([[maybe_unused]] const void* address)
{
#if defined(__GNUC__) && !defined(TOPOLOGYCARVING_PORTABLE)
  __builtin_prefetch(address);
#endif
}

/** Prefetches the entries of a cell's neighbors in each array. */
template <int D, class... Values>
[[gnu::always_inline]] inline void FetchNeighbors(
  const Decomposition<D>& mesh, int cell, const std::vector<Values>&... arrays)
{
  for (const int neighbor : mesh.Neighbors[cell])
  {
    (Prefetch(&arrays[std::max(neighbor, 0)]), ...);
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
