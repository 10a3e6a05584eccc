// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_SplitFacets_h
#define carving_SplitFacets_h

#include "Core/Mesh/Mesh.h"

#include <string>
#include <vector>

namespace carving::helper
{

/** A face that is a part of a facet of the mesh. */
struct FacetPart
{
  Triangle Corners;
  int Parent; ///< the facet
};

/**
 * Replaces the facets of a mesh by their parts, whose points the mesh already has. Returns an empty
 * string, or which facet the parts do not cover exactly once, except for rounding.
 */
std::string ReplaceByParts(const std::vector<FacetPart>& parts, ResolvedMesh& surface);

} // namespace carving::helper

#endif
