// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Points, edges and triangles whose boxes are close to each other.
 */
#ifndef carving_NearPairs_h
#define carving_NearPairs_h

#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/BoxPairs.h"
#include "Helper/Base/Kernels.h"

#include <array>
#include <cstddef>
#include <vector>

namespace carving::helper
{

/** The boxes of simplices, which are given by their points, widened by `margin` on each side. */
template <std::size_t N>
std::vector<IndexedBox> WidenedBoxes(
  const std::vector<Point>& points, const std::vector<std::array<int, N>>& simplices, double margin)
{
  std::vector<IndexedBox> boxes;
  boxes.reserve(simplices.size());
  for (const auto& simplex : simplices)
  {
    CGAL::Bbox_3 box;
    for (const int point : simplex)
    {
      box += ToInexact(points[point]).bbox();
    }
    boxes.emplace_back(CGAL::Bbox_3(box.xmin() - margin, box.ymin() - margin, box.zmin() - margin,
                         box.xmax() + margin, box.ymax() + margin, box.zmax() + margin),
      static_cast<int>(boxes.size()));
  }
  return boxes;
}

/** Each point as a simplex. */
inline std::vector<std::array<int, 1>> EachPoint(const std::vector<Point>& points)
{
  std::vector<std::array<int, 1>> simplices(points.size());
  for (std::size_t i = 0; i < simplices.size(); ++i)
  {
    simplices[i] = { static_cast<int>(i) };
  }
  return simplices;
}

/**
 * For every point, the first of the points that are within `tolerance` of it, or linked to it by
 * points that are within the tolerance of each other.
 */
inline std::vector<int> FirstNearPoints(const std::vector<Point>& points, double tolerance)
{
  DisjointSets sets(points.size());
  VisitPairs(WidenedBoxes(points, EachPoint(points), 0.5 * tolerance),
    [&](int a, int b)
    {
      if (Length(points[b] - points[a]) <= tolerance)
      {
        sets.Unite(a, b);
      }
    });
  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    first[i] = sets.Find(static_cast<int>(i));
  }
  return first;
}

/**
 * Appends points to a mesh, unless they are within `tolerance` of points of the mesh or of each
 * other. Returns the point of the mesh that each has become.
 */
inline std::vector<int> AppendDistinct(
  const std::vector<Point>& added, double tolerance, ResolvedMesh& mesh)
{
  const std::size_t given = mesh.Points.size();
  std::vector<Point> all = mesh.Points;
  all.insert(all.end(), added.begin(), added.end());
  const std::vector<int> first = FirstNearPoints(all, tolerance);
  std::vector<int> places(added.size());
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    const std::size_t near = first[given + i];
    if (near == given + i)
    {
      places[i] = static_cast<int>(mesh.Points.size());
      mesh.Points.push_back(added[i]);
      mesh.PointSources.push_back(-1);
    }
    else
    {
      places[i] = near < given ? static_cast<int>(near) : places[near - given];
    }
  }
  return places;
}

} // namespace carving::helper

#endif
