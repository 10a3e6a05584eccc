// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Flat parts of M, triangulated as the Delaunay tetrahedralization has them. Not in the paper.
 */
#ifndef carving_FlatParts_h
#define carving_FlatParts_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace carving::helper
{

struct RetriangulatedMesh
{
  ResolvedMesh Mesh; ///< each facet in the place of one of the same part
  /** The number of flat parts whose triangles were replaced. If 0, `Mesh` is incomplete. */
  int Changed = 0;
  double Distance = 0.0; ///< an upper bound of that between old and new triangles
};

/**
 * Replaces the triangles of flat parts of a mesh, which may cross itself, by faces of the Delaunay
 * tetrahedralization of its points and of `further` ones. The faces of a part have the same border.
 * A part is flat if neighboring triangles are within `tolerance`, a length, of a common plane.
 *
 * Points that lie in a plane and on a sphere but for rounding, such as those of the end of a
 * cylinder, have many triangulations. It takes long to recover a triangulation other than the
 * Delaunay tetrahedralization's. A part stays as it is where the faces do not fill its border with
 * as many triangles, are its triangles already, or are farther than the tolerance from them. A new
 * triangle takes over the source of an old one close to it.
 */
RetriangulatedMesh AdoptDelaunayFaces(
  const ResolvedMesh& mesh, const std::vector<Point>& further, double tolerance);

} // namespace carving::helper

#endif
