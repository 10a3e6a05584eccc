// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_NearDelaunay_h
#define carving_NearDelaunay_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/**
 * Whether a Delaunay tetrahedralization probably has nearly all triangles of M. Most edges of M
 * have to be Delaunay within the surface: the two angles opposite to an edge add up to less than
 * 180 degrees. Edges on the border tell nothing, so that half of all edges have to be between two
 * triangles. Takes linear time. Does not notice sheets that are closer to each other than their
 * points.
 */
bool IsNearDelaunay(const ResolvedMesh& mesh);

} // namespace carving::helper

#endif
