// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Tetrahedralize_h
#define carving_Tetrahedralize_h

#include "Core/Mesh/Mesh.h"
#include "Helper/Base/Ending.h"

#include <string>
#include <vector>

namespace carving::helper
{

/** Why C0, the hull of M and of `further` points, encloses no volume, or an empty string. */
std::string CheckVolume(const ResolvedMesh& surface, const std::vector<Point>& further);

/** Whether TetGen may add points on the surface. */
enum class SurfacePoints
{
  None,   ///< every triangle of the mesh is a face
  Allowed ///< every class of triangles (FindFacetClasses) is a union of faces, which replace it
};

/**
 * The constrained Delaunay tetrahedralization of the convex hull of a resolved mesh and of further
 * points, by TetGen.
 *
 * `result.Surface` is the mesh; the other members are filled, and the further points and Steiner
 * points are appended to its points. Throws `std::bad_alloc` if memory runs out. A failure of
 * TetGen may also end the process: its assertions are enabled, and it frees memory twice when it
 * gives up.
 */
Ending Tetrahedralize(
  const std::vector<Point>& further, SurfacePoints surfacePoints, Tetrahedralization& result);

} // namespace carving::helper

#endif
