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
  ResolvedMesh Mesh;
  /** The number of flat parts with other triangles. With 0, `Mesh` is not to be used. */
  int Changed = 0;
  double Distance = 0.0; ///< between the old and the new triangles, at most
};

/**
 * Replaces the triangles of flat parts of a mesh, which may cross itself, by faces of the Delaunay
 * tetrahedralization of its points and of `further` ones. The faces of a part have the same border.
 * A part is flat if neighboring triangles are within `tolerance`, a length, of a common plane.
 *
 * Points that lie in a plane and on a sphere but for rounding, such as those of the end of a
 * cylinder, have many triangulations. Recovering another one than that of the tetrahedralization
 * takes long. A part stays as it is where the faces do not fill its border, or are its triangles
 * already. A new triangle takes over the source of an old one close to it. If any new triangle is
 * farther than the tolerance from the old ones, nothing changes.
 */
RetriangulatedMesh AdoptDelaunayFaces(
  const ResolvedMesh& mesh, const std::vector<Point>& further, double tolerance);

} // namespace carving::helper

#endif
