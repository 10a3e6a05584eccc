// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_SplitFacets_h
#define carving_SplitFacets_h

#include "Core/Mesh/Mesh.h"

#include <string>
#include <vector>

/** A face and the facet of the mesh that it is a part of. */
struct FacetPart
{
  carving::Triangle Corners;
  int Parent;
};

/**
 * Puts the parts into which the facets of a mesh have been split in their place. The mesh has all points
 * already. Returns an empty string, or which facet the parts are not all of, up to rounding.
 */
std::string ReplaceByParts(const std::vector<FacetPart>& parts, carving::ResolvedMesh& surface);

#endif
