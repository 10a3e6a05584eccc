// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Flat parts of M, triangulated as a given tetrahedralization has them. Not in the paper.
 */
#ifndef carving_DelaunayFaces_h
#define carving_DelaunayFaces_h

#include "Helper/Enclosing/PiercedMesh.h"
#include "Helper/Recovery/FlatParts.h"

#include <vector>

namespace carving::helper
{

/**
 * Like AdoptDelaunayFaces, from a tetrahedralization that is there already. It may have further
 * points and other faces than a Delaunay tetrahedralization. Only parts with a facet that
 * `isMissing` are replaced.
 */
RetriangulatedMesh AdoptFacesOf(const PiercedMesh::Delaunay& cells, const ResolvedMesh& mesh,
  double tolerance, const std::vector<char>& isMissing);

} // namespace carving::helper

#endif
