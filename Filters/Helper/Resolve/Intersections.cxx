// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Intersections.h"

#include "Helper/Base/Kernels.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace carving::helper
{
namespace
{

/** Two triangles whose shared corners come first, in the same order. */
struct Aligned
{
  Inexact::Point_3 A[3];
  Inexact::Point_3 B[3];
  int Shared = 0;
};

Aligned Align(const std::vector<Point>& points, Triangle a, Triangle b)
{
  Aligned result;
  for (int i = 0; i < 3; ++i)
  {
    const auto found = std::find(b.begin() + result.Shared, b.end(), a[i]);
    if (found != b.end())
    {
      std::swap(a[i], a[result.Shared]);
      std::iter_swap(found, b.begin() + result.Shared);
      ++result.Shared;
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    result.A[i] = ToInexact(points[a[i]]);
    result.B[i] = ToInexact(points[b[i]]);
  }
  return result;
}

bool Intersect(const std::vector<Point>& points, const Triangle& ta, const Triangle& tb)
{
  const Aligned t = Align(points, ta, tb);
  const auto& a = t.A;
  const auto& b = t.B;
  switch (t.Shared)
  {
    case 0:
      return CGAL::do_intersect(
        Inexact::Triangle_3(a[0], a[1], a[2]), Inexact::Triangle_3(b[0], b[1], b[2]));
    case 1:
    {
      // The intersection is convex: it is more than the corner if and only if the edge opposite to
      // the corner in one triangle meets the other triangle.
      const auto sideOfB = CGAL::orientation(a[0], a[1], a[2], b[1]);
      if (sideOfB != CGAL::COPLANAR && sideOfB == CGAL::orientation(a[0], a[1], a[2], b[2]))
      {
        return false;
      }
      return CGAL::do_intersect(
               Inexact::Segment_3(a[1], a[2]), Inexact::Triangle_3(b[0], b[1], b[2])) ||
        CGAL::do_intersect(Inexact::Segment_3(b[1], b[2]), Inexact::Triangle_3(a[0], a[1], a[2]));
    }
    case 2:
      return CGAL::coplanar(a[0], a[1], a[2], b[2]) &&
        CGAL::coplanar_orientation(a[0], a[1], a[2], b[2]) == CGAL::POSITIVE;
    default:
      return false;
  }
}

} // namespace

std::vector<std::pair<int, int>> FindIntersections(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  using Box = CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_NONE>;
  struct IndexedBox : Box
  {
    IndexedBox(const CGAL::Bbox_3& bounds, int index)
      : Box(bounds)
      , Index(index)
    {
    }
    int id() const
    {
      return this->Index;
    }
    int Index;
  };
  std::vector<IndexedBox> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& t : triangles)
  {
    const CGAL::Bbox_3 bounds = ToInexact(points[t[0]]).bbox() + ToInexact(points[t[1]]).bbox() +
      ToInexact(points[t[2]]).bbox();
    boxes.emplace_back(bounds, static_cast<int>(boxes.size()));
  }
  std::vector<std::pair<int, int>> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
    [&](const IndexedBox& a, const IndexedBox& b)
    {
      if (Intersect(points, triangles[a.Index], triangles[b.Index]))
      {
        pairs.push_back(std::minmax(a.Index, b.Index));
      }
    });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace carving::helper
