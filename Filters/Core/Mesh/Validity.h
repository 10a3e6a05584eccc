// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks of meshes from files and other processes.
 */
#ifndef carving_Validity_h
#define carving_Validity_h

#include "Core/Mesh/Mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace carving
{

/** Whether all indices of all cells or facets are at least `first` and below `end`. */
template <class Tuples>
bool IndicesWithin(const Tuples& tuples, int first, std::size_t end)
{
  bool within = true; // no early exit, so that the compiler can vectorize the loop
  for (const auto& tuple : tuples)
  {
    for (const int index : tuple)
    {
      within &= index >= first && index < static_cast<long long>(end);
    }
  }
  return within;
}

/** Likewise for single indices. */
inline bool IndicesWithin(const std::vector<int>& indices, int first, std::size_t end)
{
  bool within = true;
  for (const int index : indices)
  {
    within &= index >= first && index < static_cast<long long>(end);
  }
  return within;
}

/** Whether no coordinate is infinite or NaN. */
bool AreFinite(const std::vector<Point>& points);

/** Whether all corners of all cells or facets differ from each other. */
template <class Tuples>
bool CornersDiffer(const Tuples& tuples)
{
  bool differ = true;
  for (const auto& tuple : tuples)
  {
    for (std::size_t i = 0; i < tuple.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        differ &= tuple[i] != tuple[j];
      }
    }
  }
  return differ;
}

/**
 * The first violation of the contract of Decomposition, or an empty string. Checks array lengths,
 * indices, the agreement of neighbors, cells and facets, and that coordinates are finite. Does not
 * check whether cells overlap in space. `solidSides` has, per facet of M, behind it and in front of
 * it, a negative number or one that stands for cells of the solid that the mesh lacks; it is empty
 * if the mesh has all cells. The result does not depend on `threads`.
 */
template <int D>
std::string FindMistake(const Decomposition<D>& mesh,
  const std::vector<std::array<int, 2>>& solidSides = {}, int threads = 1);

} // namespace carving

#endif
