// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/Kernels.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/determinant.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

using carving::Point;
using carving::Triangle;
using namespace carving::helper;

namespace checks
{
namespace
{

Inexact::Triangle_3 ToTriangle(const std::vector<Point>& points, const Triangle& t)
{
  return { ToInexact(points[t[0]]), ToInexact(points[t[1]]), ToInexact(points[t[2]]) };
}

/**
 * Moves the corners that two triangles share to the front, in the same order; returns their number.
 */
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
 * Whether two triangles meet in more than the corners that they share. Predicates suffice: they are
 * exact, and the intersection need not be constructed.
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
      // The intersection is convex: if it is more than the corner, it reaches an edge opposite to
      // the corner.
      return CGAL::do_intersect(oppositeSide(a), ToTriangle(points, b)) ||
        CGAL::do_intersect(oppositeSide(b), ToTriangle(points, a));
    case 2:
    {
      // Only coplanar triangles on the same side of their edge have more than the edge in common.
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

std::vector<Triangle> WithPointsMerged(
  const std::vector<Point>& points, std::vector<Triangle> triangles)
{
  std::map<Point, int> first;
  for (Triangle& t : triangles)
  {
    for (int& corner : t)
    {
      corner = first.emplace(points[corner], corner).first->second;
    }
  }
  return triangles;
}

bool IsClosed(const std::vector<Triangle>& triangles)
{
  std::map<std::pair<int, int>, int> passages;
  for (const Triangle& t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = t[i], b = t[(i + 1) % 3];
      passages[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return std::all_of(
    passages.begin(), passages.end(), [](const auto& edge) { return edge.second == 0; });
}

double SixVolume(const carving::Tetrahedralization& mesh)
{
  const std::vector<Point>& p = mesh.Surface.Points;
  double sum = 0.0;
  for (const auto& [a, b, c, d] : mesh.Cells)
  {
    const double volume = carving::SixVolume(p[a], p[b], p[c], p[d]);
    sum += volume > 0.0 ? volume : NAN;
  }
  return sum;
}

double SixVolume(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  CGAL::MP_Float sum = 0;
  for (const Triangle& t : triangles)
  {
    const auto at = [&](int corner, int axis) { return CGAL::MP_Float(points[t[corner]][axis]); };
    sum += CGAL::determinant(
      at(0, 0), at(0, 1), at(0, 2), at(1, 0), at(1, 1), at(1, 2), at(2, 0), at(2, 1), at(2, 2));
  }
  return CGAL::to_double(sum);
}

Passages CountPassages(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles, const Point& point)
{
  const Inexact::Point_3 p = ToInexact(point);
  const Inexact::Point_3 q = p + Inexact::Vector_3(1234.56789, 2718.28182, 3141.59265);
  Passages passages;
  for (const Triangle& t : triangles)
  {
    const Inexact::Point_3 a = ToInexact(points[t[0]]), b = ToInexact(points[t[1]]),
                           c = ToInexact(points[t[2]]);
    const auto sideOfP = CGAL::orientation(a, b, c, p), sideOfQ = CGAL::orientation(a, b, c, q);
    if (sideOfP == sideOfQ || sideOfP == CGAL::COPLANAR)
    {
      continue;
    }
    const auto ab = CGAL::orientation(p, q, a, b);
    if (ab == CGAL::orientation(p, q, b, c) && ab == CGAL::orientation(p, q, c, a))
    {
      passages.Sum += sideOfP == CGAL::NEGATIVE ? 1 : -1;
      ++passages.Count;
    }
  }
  return passages;
}

bool Encloses(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles, const Point& point)
{
  const bool touches = std::any_of(triangles.begin(), triangles.end(),
    [&](const Triangle& t) { return CGAL::do_intersect(ToTriangle(points, t), ToInexact(point)); });
  return touches || CountPassages(points, triangles, point).Count % 2 != 0;
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
  std::vector<Point> vertices;
  for (const auto vertex : mesh.vertices())
  {
    const auto& p = mesh.point(vertex);
    vertices.push_back({ p.x(), p.y(), p.z() });
  }
  std::vector<Triangle> triangles;
  for (const auto face : mesh.faces())
  {
    const auto halfedge = mesh.halfedge(face);
    const int first = static_cast<int>(mesh.source(halfedge));
    for (auto next = mesh.next(halfedge); mesh.target(next) != mesh.source(halfedge);
         next = mesh.next(next))
    {
      triangles.push_back(
        { first, static_cast<int>(mesh.source(next)), static_cast<int>(mesh.target(next)) });
    }
  }
  const double sixVolume = SixVolume(vertices, triangles);
  std::sort(vertices.begin(), vertices.end());
  return { vertices, sixVolume };
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
  // Rounding errors of squared distances are large errors of small distances.
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const CGAL::Cartesian_converter<Inexact, Exact> toExact;
  const double slack = 1e-12 * CGAL::squared_distance(ToInexact(points[0]), ToInexact(point));
  double least = HUGE_VAL;
  std::vector<std::pair<double, std::size_t>> close; // squared distances and triangles
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto& [a, b, c] = triangles[i];
    if (carving::BoxAround({ points[a], points[b], points[c] }).SquaredDistanceTo(point) <=
      least + slack)
    {
      close.emplace_back(
        CGAL::squared_distance(ToInexact(point), ToTriangle(points, triangles[i])), i);
      least = std::min(least, close.back().first);
    }
  }
  double nearest = HUGE_VAL;
  for (const auto& [square, i] : close)
  {
    if (square <= least + slack)
    {
      const auto exact = CGAL::squared_distance(
        toExact(ToInexact(point)), toExact(ToTriangle(points, triangles[i])));
      nearest = std::min(nearest, CGAL::to_double(exact.exact()));
    }
  }
  return std::sqrt(nearest);
}

double FarthestOfGrid(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
  const std::array<Point, 3>& t)
{
  constexpr int N = 40;
  double farthest = 0.0;
  for (int i = 0; i <= N; ++i)
  {
    for (int j = 0; j <= N - i; ++j)
    {
      const double a = i / double(N), b = j / double(N), c = 1.0 - a - b;
      using carving::operator+, carving::operator*;
      const Point p = a * t[0] + b * t[1] + c * t[2];
      farthest = std::max(farthest, DistanceTo(points, triangles, p));
    }
  }
  return farthest;
}

} // namespace checks
