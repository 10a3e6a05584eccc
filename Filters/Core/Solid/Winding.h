// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Solid angles and winding numbers.
 */
#ifndef carving_Winding_h
#define carving_Winding_h

#include "Core/Mesh/Mesh.h"

#include <cstddef>
#include <vector>

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
 * Whether each facet of M belongs to a closed part. A part consists of the facets that are joined
 * across edges (in the plane, vertices), and is closed if they, counted with their signed
 * multiplicities, traverse every edge (vertex) as often in one direction as in the other. The
 * winding number of a closed part is an integer everywhere off this part and changes across its
 * facets only. A facet whose signed multiplicity is 0 joins nothing, and is closed by itself.
 */
template <int D>
std::vector<char> FindClosedParts(const ResolvedInput<D>& mesh);

/** Whether M has closed parts only. */
bool IsClosed(const ResolvedMesh& mesh);

} // namespace carving

#endif
