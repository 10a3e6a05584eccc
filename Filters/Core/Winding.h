// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Winding number of a triangle soup around a point.
 */
#ifndef carving_Winding_h
#define carving_Winding_h

#include "Mesh.h"

namespace carving
{

/**
 * Generalized winding number of M around a point that lies on no triangle: the sum of the signed
 * solid angles of all triangles, each times its entry in `Windings`, over 4 pi. An integer where M
 * is closed and consistently oriented.
 */
double WindingNumber(const ResolvedMesh& mesh, const Point& point);

/**
 * Whether every edge of M is crossed as often in one direction as in the other, counting `Windings`.
 * Then the winding number is an integer everywhere off M and changes only across triangles.
 */
bool IsClosed(const ResolvedMesh& mesh);

} // namespace carving

#endif
