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

/** The signed solid angle of a triangle, positive where the point lies behind the triangle. */
double SolidAngle(const ResolvedMesh& mesh, std::size_t triangle, const Point& point);

/**
 * The generalized winding number of M around a point that lies on no facet. In space, the sum of
 * the signed solid angles of all triangles, each times its signed multiplicity, divided by 4 pi; in
 * the plane, the sum of the signed angles of all edges, divided by 2 pi. An integer if M is closed
 * and consistently oriented.
 */
double WindingNumber(const ResolvedMesh& mesh, const Point& point);
double WindingNumber(const ResolvedInput<2>& contours, const Point& point);

/**
 * The number of triangles of M that a ray from a point crosses, counted with their multiplicities.
 * No model is likely to be aligned with the ray's direction. In floating point: a triangle that
 * contains a part of the ray may or may not be counted.
 */
int CountCrossings(const ResolvedMesh& mesh, const Point& point);

/**
 * Whether the facets of M, counted with their signed multiplicities, traverse every edge (in the
 * plane, every vertex) as often in one direction as in the other. If so, the winding number is an
 * integer everywhere off M and changes across facets only.
 */
bool IsClosed(const ResolvedInput<2>& contours);
bool IsClosed(const ResolvedInput<3>& mesh);

} // namespace carving

#endif
