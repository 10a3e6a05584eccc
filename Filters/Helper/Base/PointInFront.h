// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_PointInFront_h
#define carving_PointInFront_h

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <array>
#include <cfloat>

namespace carving::helper
{

/**
 * A point in front of the center of a triangle with an area, at a distance that is raised to some
 * roundings of the coordinates.
 */
inline Point PointInFront(const std::array<Point, 3>& corners, double distance)
{
  constexpr double roundings = 64.0;
  const auto& [a, b, c] = corners;
  const Point normal = Cross(b - a, c - a);
  const Point center = a / 3.0 + b / 3.0 + c / 3.0;
  const double step = std::max(distance, roundings * DBL_EPSILON * Length(center));
  return center + step / Length(normal) * normal;
}

} // namespace carving::helper

#endif
