// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Intersections_h
#define carving_Intersections_h

#include "Core/Mesh/Mesh.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace carving::helper
{

/** No mesh with so many can be resolved. The list of them would fill the memory. */
constexpr std::size_t MostIntersections = 10000000;

/**
 * All pairs of triangles whose intersection is more than their shared vertices or their shared
 * edge, in ascending order, the lower index first. Exact. The mesh has been cleaned. The search
 * ends at `most` pairs, which may be any then.
 */
std::vector<std::pair<int, int>> FindIntersections(const std::vector<Point>& points,
  const std::vector<Triangle>& triangles, std::size_t most = MostIntersections);

} // namespace carving::helper

#endif
