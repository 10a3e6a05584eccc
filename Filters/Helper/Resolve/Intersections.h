// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Intersections_h
#define carving_Intersections_h

#include "Core/Mesh/Mesh.h"

#include <utility>
#include <vector>

/**
 * All pairs of triangles, the smaller index first and in ascending order, that have more in common
 * than shared vertices or a shared edge. Decided by exact predicates. The mesh has been cleaned.
 */
std::vector<std::pair<int, int>> FindIntersections(
  const std::vector<carving::Point>& points, const std::vector<carving::Triangle>& triangles);

#endif
