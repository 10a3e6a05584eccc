// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Flat parts of M, triangulated as a given Delaunay tetrahedralization has them. Not in the paper.
 */
#ifndef carving_DelaunayFaces_h
#define carving_DelaunayFaces_h

#include "Helper/Enclosing/PiercedMesh.h"
#include "Helper/Recovery/FlatParts.h"

namespace carving::helper
{

/** As AdoptDelaunayFaces, with a tetrahedralization of the mesh's points, and maybe of others. */
RetriangulatedMesh AdoptFacesOf(
  const PiercedMesh::Delaunay& delaunay, const ResolvedMesh& mesh, double tolerance);

} // namespace carving::helper

#endif
