// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Solid angles and winding numbers.
 */
#ifndef carving_Winding_h
#define carving_Winding_h

#include "Core/Mesh/Mesh.h"

#include <cstddef>

namespace carving
{

/** Signed solid angle of a triangle: positive where the point lies behind it. */
double SolidAngle(const ResolvedMesh& mesh, std::size_t triangle, const Point& point);

/**
 * Generalized winding number of M around a point that lies on no facet: the sum of the signed solid
 * angles of all triangles, or of the signed angles of all edges in the projection along z, each times
 * its entry in `SignedMultiplicities`, as a share of the full angle. An integer where M is closed and consistently
 * oriented.
 */
double WindingNumber(const ResolvedMesh& mesh, const Point& point);
double WindingNumber(const ResolvedInput<2>& contours, const Point& point);

/**
 * How many triangles of M, merged ones by their number, a ray from a point crosses, in a direction that
 * no model is aligned with. In floating point: a ray that runs along a triangle may count it or not.
 */
int CountCrossings(const ResolvedMesh& mesh, const Point& point);

/**
 * Whether every edge of M (every vertex, in the plane) is passed as often in one direction as in the
 * other, counting `SignedMultiplicities`. Then the winding number is an integer everywhere off M and changes only
 * across facets.
 */
template <int D>
bool IsClosed(const ResolvedInput<D>& input);

} // namespace carving

#endif
