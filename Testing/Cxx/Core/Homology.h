// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Betti numbers by linear algebra over Z/2, from simplices alone: by other means than those of the
 * code under test, which counts merges of sets and Euler characteristics.
 */
#ifndef Homology_h
#define Homology_h

#include "Core/Carving/Carver.h"
#include "Core/Mesh/Mesh.h"

#include <array>
#include <vector>

namespace homology
{

/** Its corners, in any order. */
using Simplex = std::vector<int>;

/** Entry k is the rank of the k-th homology group: components, tunnels, voids, and in space 0. */
using BettiNumbers = std::array<int, 4>;

/**
 * Of the complex of all faces of some simplices of at most four corners, by the ranks of its
 * boundary matrices. With `collapse` simplices that are in the way of none are removed from it in
 * pairs first (elementary collapses), without which large complexes take too long.
 */
BettiNumbers ComputeBettiNumbers(const std::vector<Simplex>& simplices, bool collapse = true);

/**
 * K_step: the facets of M, and the cells that are not carved away until `step`, those of the solid
 * too.
 */
template <int D>
std::vector<Simplex> ClosedComplex(
  const carving::Decomposition<D>& mesh, const carving::Stream& stream, int step)
{
  std::vector<Simplex> simplices;
  for (const auto& facet : mesh.Surface.Facets)
  {
    simplices.emplace_back(facet.begin(), facet.end());
  }
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    if (stream.Step[cell] > step)
    {
      simplices.emplace_back(mesh.Cells[cell].begin(), mesh.Cells[cell].end());
    }
  }
  return simplices;
}

} // namespace homology

#endif
