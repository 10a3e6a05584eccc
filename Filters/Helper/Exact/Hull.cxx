// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/Hull.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/Kernels.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cmath>
#include <vector>

namespace carving::helper
{
namespace
{

double SixHullVolume(const std::vector<Point>& points)
{
  std::vector<Inexact::Point_3> all;
  all.reserve(points.size());
  for (const Point& p : points)
  {
    all.push_back(ToInexact(p));
  }
  CGAL::Surface_mesh<Inexact::Point_3> hull;
  CGAL::convex_hull_3(all.begin(), all.end(), hull);
  double sum = 0.0;
  for (const auto face : hull.faces())
  {
    std::vector<Point> corners;
    for (const auto v : hull.vertices_around_face(hull.halfedge(face)))
    {
      const Inexact::Point_3& p = hull.point(v);
      corners.push_back({ p[0], p[1], p[2] });
    }
    sum -= SixVolume(corners[0], corners[1], corners[2], points.front());
  }
  return sum;
}

/**
 * All points whose convex hull is that of all points: points inside the union of the cells are left
 * out.
 */
std::vector<Point> PointsAtBoundary(const Tetrahedralization& mesh)
{
  std::vector<char> isInside(mesh.Surface.Points.size(), 0);
  for (const Tetrahedralization::Cell& cell : mesh.Cells)
  {
    for (const int vertex : cell)
    {
      isInside[vertex] = 1;
    }
  }
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      if (mesh.Neighbors[cell][f] < 0)
      {
        for (const int vertex : mesh.OutwardFace(static_cast<int>(cell), f))
        {
          isInside[vertex] = 0;
        }
      }
    }
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < isInside.size(); ++i)
  {
    if (!isInside[i])
    {
      points.push_back(mesh.Surface.Points[i]);
    }
  }
  return points;
}

} // namespace

bool FillsHull(const Tetrahedralization& mesh)
{
  const std::vector<Point>& points = mesh.Surface.Points;
  double sum = 0.0;
  for (const auto& [a, b, c, d] : mesh.Cells)
  {
    sum += SixVolume(points[a], points[b], points[c], points[d]);
  }
  const double hull = SixHullVolume(PointsAtBoundary(mesh));
  return std::abs(sum - hull) <= 1e-9 * hull + 1e-14 * std::pow(Diagonal(points), 3.0);
}

} // namespace carving::helper
