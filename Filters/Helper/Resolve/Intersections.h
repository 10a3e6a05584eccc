// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Intersections_h
#define carving_Intersections_h

#include "Core/Mesh/Mesh.h"

#include <utility>
#include <vector>

namespace carving::helper
{

/**
 * All pairs of triangles whose intersection is more than their shared vertices or their shared
 * edge, in ascending order, the lower index first. Exact. The mesh has been cleaned.
 */
std::vector<std::pair<int, int>> FindIntersections(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles);

} // namespace carving::helper

#endif
