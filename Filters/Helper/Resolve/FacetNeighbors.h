// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_FacetNeighbors_h
#define carving_FacetNeighbors_h

#include "Core/Mesh/Mesh.h"

#include <array>
#include <vector>

namespace carving::helper
{

/** The neighbor of a facet across an edge that no third facet has. */
struct FacetNeighbor
{
  int Facet = -1;       ///< -1: none
  bool Flipped = false; ///< the corners of the two facets are inconsistently oriented
};

/** Of a facet, across the edge from each corner to the next. */
using FacetNeighbors = std::array<FacetNeighbor, 3>;

std::vector<FacetNeighbors> FindFacetNeighbors(const ResolvedMesh& mesh);

} // namespace carving::helper

#endif
