// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Tetrahedralize_h
#define carving_Tetrahedralize_h

#include "Core/Mesh/Mesh.h"
#include "Helper/Base/Ending.h"

#include <string>
#include <vector>

/** Why there is nothing between M, with further points of C0, and its hull, or an empty string. */
std::string CheckVolume(
  const carving::ResolvedMesh& surface, const std::vector<carving::Point>& further);

/** Whether TetGen may put points on the surface. */
enum class SurfacePoints
{
  None,   ///< every triangle of the mesh is a face
  Allowed ///< every triangle is a union of faces, which take its place in the surface
};

/**
 * Constrained Delaunay tetrahedralization of the convex hull of a resolved mesh and of further points, by
 * TetGen.
 *
 * Fills the other members of `result`, whose `Surface` is given, and appends the further points and
 * Steiner points. Throws `std::bad_alloc` where memory runs out. Where TetGen fails it may as well end the
 * process: its assertions are on, and it frees memory twice when it gives up.
 */
Ending Tetrahedralize(const std::vector<carving::Point>& further, SurfacePoints surfacePoints,
  carving::Tetrahedralization& result);

/** The corners of the points' bounding box, grown by BoxMargin of its diagonal on every side. */
std::vector<carving::Point> GrownBox(const std::vector<carving::Point>& points);

#endif
