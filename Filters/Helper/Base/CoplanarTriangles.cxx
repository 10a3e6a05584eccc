// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Base/CoplanarTriangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carving::helper
{
namespace
{

using Flat = std::array<Inexact::Point_2, 3>;

Flat Project(const Corners3& t, const std::array<int, 2>& axes)
{
  Flat flat;
  for (int i = 0; i < 3; ++i)
  {
    flat[i] = { t[i][axes[0]], t[i][axes[1]] };
  }
  return flat;
}

CGAL::Orientation OrientationOf(const Flat& t)
{
  return CGAL::orientation(t[0], t[1], t[2]);
}

double TwiceArea(const Flat& t)
{
  const auto [ux, uy] = std::array{ t[1].x() - t[0].x(), t[1].y() - t[0].y() };
  const auto [vx, vy] = std::array{ t[2].x() - t[0].x(), t[2].y() - t[0].y() };
  return std::abs(ux * vy - uy * vx);
}

/**
 * Two coordinate axes, ordered so that the projection of the triangle along the third is
 * counter-clockwise. The largest projection comes first: in others, roundings may prevail.
 */
std::array<int, 2> ProjectionOf(const Corners3& t)
{
  std::array<std::array<int, 2>, 3> all = { { { 0, 1 }, { 1, 2 }, { 2, 0 } } };
  std::stable_sort(all.begin(), all.end(),
    [&](const auto& a, const auto& b)
    { return TwiceArea(Project(t, a)) > TwiceArea(Project(t, b)); });
  for (const auto& [x, y] : all)
  {
    const CGAL::Orientation orientation = OrientationOf(Project(t, { x, y }));
    if (orientation != CGAL::COLLINEAR)
    {
      return orientation == CGAL::POSITIVE ? std::array{ x, y } : std::array{ y, x };
    }
  }
  return { 0, 1 }; // not reached for a triangle that has an area
}

/**
 * Whether an edge of a counter-clockwise triangle has all of another triangle on its outer side.
 */
bool EdgeSeparates(const Flat& a, const Flat& b)
{
  for (int i = 0; i < 3; ++i)
  {
    bool outside = true;
    for (int k = 0; k < 3 && outside; ++k)
    {
      outside = CGAL::orientation(a[i], a[(i + 1) % 3], b[k]) != CGAL::POSITIVE;
    }
    if (outside)
    {
      return true;
    }
  }
  return false;
}

} // namespace

bool Overlap(const Corners3& a, const Corners3& b)
{
  const std::array<int, 2> axes = ProjectionOf(a);
  const Flat first = Project(a, axes);
  Flat second = Project(b, axes);
  if (OrientationOf(second) == CGAL::NEGATIVE)
  {
    std::swap(second[1], second[2]);
  }
  return !EdgeSeparates(first, second) && !EdgeSeparates(second, first);
}

bool FaceAlike(const Corners3& a, const Corners3& b)
{
  return OrientationOf(Project(b, ProjectionOf(a))) == CGAL::POSITIVE;
}

} // namespace carving::helper
