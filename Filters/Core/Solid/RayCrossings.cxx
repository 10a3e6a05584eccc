// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/RayCrossings.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <limits>

namespace carving
{
namespace
{

/** No model is likely to be aligned with one of these. */
constexpr Point Directions[] = { { 0.5377, 0.2913, 0.7912 }, { -0.7213, 0.6387, -0.2679 } };

/** Whether the ray from a point may meet a box; rounding adds some boxes, but leaves out none. */
bool MayMeet(const Point& point, const Point& direction, const Box& box)
{
  constexpr double slack = 1e-12; // relative
  double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const auto [first, last] = std::minmax(
      { (box.Lower[i] - point[i]) / direction[i], (box.Upper[i] - point[i]) / direction[i] });
    enters = std::max(enters, first);
    leaves = std::min(leaves, last);
  }
  return enters * (1.0 - slack) <= leaves * (1.0 + slack);
}

/**
 * The ray from a point crosses a triangle if all edges pass it on the same side and the triangle
 * lies ahead.
 */
bool Crosses(const Point& point, const Point& direction, const FacetCorners<3>& corners)
{
  const Point a = corners[0] - point, b = corners[1] - point, c = corners[2] - point;
  const double ab = Dot(direction, Cross(a, b)), bc = Dot(direction, Cross(b, c)),
               ca = Dot(direction, Cross(c, a));
  const bool within = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
  return within && (Dot(a, Cross(b, c)) > 0) == (ab > 0);
}

} // namespace

std::array<int, 2> RayCrossings::Count(const Point& point) const
{
  return { this->Count(point, Directions[0]), this->Count(point, Directions[1]) };
}

int RayCrossings::Count(const Point& point, const Point& direction) const
{
  const FacetItems<3>& items = this->Tree.GetItems();
  int count = 0;
  this->Tree.Any([&](const Box& box) { return MayMeet(point, direction, box); },
    [&](int triangle)
    {
      const bool crosses = Crosses(point, direction, items.CornersOf(triangle));
      count += crosses ? items.GetMesh().Multiplicities[triangle] : 0;
      return false; // all of them
    });
  return count;
}

} // namespace carving
