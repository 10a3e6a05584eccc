// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"

#include "Kernels.h"
#include "Vector.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>

using carving::Point;
using carving::Triangle;

namespace checks
{
namespace
{

Exact::Triangle_3 ExactTriangle(const std::vector<Point>& points, const Triangle& t)
{
  return { ToExact(points[t[0]]), ToExact(points[t[1]]), ToExact(points[t[2]]) };
}

/** Whether what two triangles have in common is just the points that they share. */
struct IsJust
{
  using result_type = bool;
  const std::vector<Exact::Point_3>& Shared;

  bool Contains(const Exact::Point_3& p) const
  {
    return std::find(this->Shared.begin(), this->Shared.end(), p) != this->Shared.end();
  }
  bool operator()(const Exact::Point_3& p) const
  {
    return this->Contains(p);
  }
  bool operator()(const Exact::Segment_3& s) const
  {
    return this->Shared.size() == 2 && this->Contains(s.source()) && this->Contains(s.target());
  }
  bool operator()(const Exact::Triangle_3&) const
  {
    return false;
  }
  bool operator()(const std::vector<Exact::Point_3>&) const
  {
    return false;
  }
};

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
    [&](const Box& x, const Box& y)
    {
      const Triangle& a = *x.handle();
      const Triangle& b = *y.handle();
      std::vector<Exact::Point_3> shared;
      for (const int corner : a)
      {
        if (std::find(b.begin(), b.end(), corner) != b.end())
        {
          shared.push_back(ToExact(points[corner]));
        }
      }
      const auto met = CGAL::intersection(ExactTriangle(points, a), ExactTriangle(points, b));
      crossings += met && !boost::apply_visitor(IsJust{ shared }, *met);
    });
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
    [&](const Triangle& t)
    {
      return CGAL::do_intersect(line,
        Inexact::Triangle_3(
          ToInexact(points[t[0]]), ToInexact(points[t[1]]), ToInexact(points[t[2]])));
    });
}

} // namespace checks
