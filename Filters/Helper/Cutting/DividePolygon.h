// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_DividePolygon_h
#define carving_DividePolygon_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace carving::helper
{

/**
 * A convex polygon. A side is the vertices on it from corner to corner, both included; the last
 * corner of each is the first of the next.
 */
using Sides = std::vector<std::vector<int>>;

/**
 * Triangles that fill a polygon. All vertices on its sides are corners of them, and their edges are
 * short. Triangles between vertices that coincide are left out.
 */
std::vector<Triangle> DividePolygon(const Sides& polygon, const std::vector<Point>& points);

/**
 * Triangles that fill the gap between a side with vertices on it and the straight line between its
 * ends. Together, they are as long as the side, times the logarithm of the number of vertices.
 */
std::vector<Triangle> FillGap(const std::vector<int>& side);

} // namespace carving::helper

#endif
