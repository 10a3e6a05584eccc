// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"

#include "Kernels.h"
#include "Vector.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>

using carving::Point;
using carving::Triangle;

namespace checks
{
namespace
{

Inexact::Triangle_3 ToTriangle(const std::vector<Point>& points, const Triangle& t)
{
  return { ToInexact(points[t[0]]), ToInexact(points[t[1]]), ToInexact(points[t[2]]) };
}

/** How many corners two triangles share; orders each by shared corners first, those in one order. */
int ShareFirst(Triangle& a, Triangle& b)
{
  int shared = 0;
  for (int i = 0; i < 3; ++i)
  {
    const auto same = std::find(b.begin() + shared, b.end(), a[i]);
    if (same != b.end())
    {
      std::swap(a[shared], a[i]);
      std::swap(b[shared], *same);
      ++shared;
    }
  }
  return shared;
}

/**
 * Whether triangles meet in more than the corners that they share. By predicates alone: they are exact
 * without exact coordinates of what the triangles have in common.
 */
bool Cross(const std::vector<Point>& points, Triangle a, Triangle b)
{
  const auto oppositeSide = [&](const Triangle& t)
  { return Inexact::Segment_3(ToInexact(points[t[1]]), ToInexact(points[t[2]])); };
  switch (ShareFirst(a, b))
  {
    case 0:
      return CGAL::do_intersect(ToTriangle(points, a), ToTriangle(points, b));
    case 1:
      // What they have in common is convex: if it goes on from the corner, then to a side opposite to it.
      return CGAL::do_intersect(oppositeSide(a), ToTriangle(points, b)) ||
        CGAL::do_intersect(oppositeSide(b), ToTriangle(points, a));
    case 2:
    {
      // Unless one lies flat on the other, they have their side in common and nothing else.
      const Inexact::Point_3 p = ToInexact(points[a[0]]), q = ToInexact(points[a[1]]),
                             r = ToInexact(points[a[2]]), s = ToInexact(points[b[2]]);
      return CGAL::orientation(p, q, r, s) == CGAL::COPLANAR &&
        CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
    }
    default:
      return true;
  }
}

} // namespace

int CountCrossings(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Triangle*>;
  std::vector<Box> boxes;
  for (const Triangle& t : triangles)
  {
    boxes.emplace_back(ToInexact(points[t[0]]).bbox() + ToInexact(points[t[1]]).bbox() +
        ToInexact(points[t[2]]).bbox(),
      &t);
  }
  int crossings = 0;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
    [&](const Box& x, const Box& y) { crossings += Cross(points, *x.handle(), *y.handle()); });
  return crossings;
}

double SixVolume(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles)
  {
    sum += carving::Dot(points[a], carving::Cross(points[b], points[c]));
  }
  return sum;
}

bool Encloses(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles, const Point& point)
{
  // Parity of crossings on the way out, in a direction that is in line with nothing.
  const Inexact::Point_3 p = ToInexact(point);
  const Inexact::Point_3 q = p + Inexact::Vector_3(1234.56789, 2718.28182, 3141.59265);
  bool inside = false;
  for (const Triangle& t : triangles)
  {
    const Inexact::Point_3 a = ToInexact(points[t[0]]), b = ToInexact(points[t[1]]),
                           c = ToInexact(points[t[2]]);
    const auto sideOfP = CGAL::orientation(a, b, c, p);
    if (sideOfP == CGAL::COPLANAR)
    {
      if (CGAL::do_intersect(Inexact::Triangle_3(a, b, c), p))
      {
        return true;
      }
      continue;
    }
    const auto ab = CGAL::orientation(p, q, a, b);
    inside ^= sideOfP != CGAL::orientation(a, b, c, q) && ab == CGAL::orientation(p, q, b, c) &&
      ab == CGAL::orientation(p, q, c, a);
  }
  return inside;
}

Hull ConvexHull(const std::vector<Point>& points)
{
  std::vector<Inexact::Point_3> all;
  for (const Point& p : points)
  {
    all.push_back(ToInexact(p));
  }
  CGAL::Surface_mesh<Inexact::Point_3> mesh;
  CGAL::convex_hull_3(all.begin(), all.end(), mesh);
  Hull hull = { {}, 0.0 };
  for (const auto vertex : mesh.vertices())
  {
    const auto& p = mesh.point(vertex);
    hull.Vertices.push_back({ p.x(), p.y(), p.z() });
  }
  std::sort(hull.Vertices.begin(), hull.Vertices.end());
  for (const auto face : mesh.faces())
  {
    auto halfedge = mesh.halfedge(face);
    const auto& a = mesh.point(mesh.source(halfedge));
    for (halfedge = mesh.next(halfedge); mesh.target(halfedge) != mesh.source(mesh.halfedge(face));
         halfedge = mesh.next(halfedge))
    {
      const auto& b = mesh.point(mesh.source(halfedge));
      const auto& c = mesh.point(mesh.target(halfedge));
      hull.SixVolume += carving::Dot(
        { a.x(), a.y(), a.z() }, carving::Cross({ b.x(), b.y(), b.z() }, { c.x(), c.y(), c.z() }));
    }
  }
  return hull;
}

bool LineHits(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
  const Point& point, const Point& direction)
{
  const Inexact::Line_3 line(
    ToInexact(point), Inexact::Vector_3(direction[0], direction[1], direction[2]));
  return std::any_of(triangles.begin(), triangles.end(),
    [&](const Triangle& t) { return CGAL::do_intersect(line, ToTriangle(points, t)); });
}

double DistanceTo(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles, const Point& point)
{
  double nearest = HUGE_VAL; // squared
  for (const Triangle& t : triangles)
  {
    nearest = std::min(
      nearest, CGAL::to_double(CGAL::squared_distance(ToInexact(point), ToTriangle(points, t))));
  }
  return std::sqrt(nearest);
}

} // namespace checks
