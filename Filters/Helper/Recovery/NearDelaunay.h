// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_NearDelaunay_h
#define carving_NearDelaunay_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/**
 * Whether a Delaunay tetrahedralization probably has nearly all triangles of M: most edges of M
 * have the Delaunay property within the surface, which is that the two angles opposite to them add
 * up to less than 180 degrees. Takes linear time. Sheets closer to each other than their points are
 * not noticed.
 */
bool IsNearDelaunay(const ResolvedMesh& mesh);

} // namespace carving::helper

#endif
