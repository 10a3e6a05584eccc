// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Base/GrownBox.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"

namespace carving::helper
{

std::vector<Point> GrownBox(const std::vector<Point>& points)
{
  const auto [lower, upper] = BoxAround(points);
  const double margin = BoxMargin * Length(upper - lower);
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
  {
    Point corner;
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[axis] = i >> axis & 1 ? upper[axis] + margin : lower[axis] - margin;
    }
    corners.push_back(corner);
  }
  return corners;
}

} // namespace carving::helper
