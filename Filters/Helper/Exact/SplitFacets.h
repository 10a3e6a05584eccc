// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Facets that TetGen has split, or cut in another way together with others of the same class.
 */
#ifndef carving_SplitFacets_h
#define carving_SplitFacets_h

#include "Core/Mesh/Mesh.h"

#include <string>
#include <vector>

namespace carving::helper
{

/**
 * The class of each facet, numbered from 0. The facets of a class are parts of the same given
 * triangle and have the same direction and multiplicities. So any other triangulation of their
 * union can take their place.
 */
std::vector<int> FindFacetClasses(const ResolvedMesh& surface);

/** A face that is a part of the facets of a class. */
struct FacetPart
{
  Triangle Corners;
  int Class;
};

/**
 * Replaces the facets of a mesh by their parts, whose points the mesh already has. `classes` has
 * the class of each facet. Returns an empty string, or which facets the parts do not cover exactly
 * once, except for rounding.
 */
std::string ReplaceByParts(
  const std::vector<FacetPart>& parts, const std::vector<int>& classes, ResolvedMesh& surface);

} // namespace carving::helper

#endif
