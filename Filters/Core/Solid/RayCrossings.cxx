// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/RayCrossings.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <limits>

namespace carving
{
namespace
{

constexpr Point Direction = { 0.5377, 0.2913, 0.7912 };

/** Whether the ray from a point may meet a box; rounding adds some boxes, but leaves out none. */
bool MayMeet(const Point& point, const Box& box)
{
  constexpr double slack = 1e-12; // relative
  double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    enters = std::max(enters, (box.Lower[i] - point[i]) / Direction[i]);
    leaves = std::min(leaves, (box.Upper[i] - point[i]) / Direction[i]);
  }
  return enters * (1.0 - slack) <= leaves * (1.0 + slack);
}

/**
 * The ray from a point crosses a triangle if all edges pass it on the same side and the triangle
 * lies ahead.
 */
bool Crosses(const Point& point, const FacetCorners<3>& corners)
{
  const Point a = corners[0] - point, b = corners[1] - point, c = corners[2] - point;
  const double ab = Dot(Direction, Cross(a, b)), bc = Dot(Direction, Cross(b, c)),
               ca = Dot(Direction, Cross(c, a));
  const bool within = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
  return within && (Dot(a, Cross(b, c)) > 0) == (ab > 0);
}

} // namespace

int RayCrossings::Count(const Point& point) const
{
  const FacetItems<3>& items = this->Tree.GetItems();
  int count = 0;
  this->Tree.Any([&point](const Box& box) { return MayMeet(point, box); },
    [&](int triangle)
    {
      count +=
        Crosses(point, items.CornersOf(triangle)) ? items.GetMesh().Multiplicities[triangle] : 0;
      return false; // all of them
    });
  return count;
}

} // namespace carving
