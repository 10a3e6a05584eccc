// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Intersections.h"

#include "Helper/Base/BoxPairs.h"
#include "Helper/Base/TriangleCrossing.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

Corners3 CornersOf(const std::vector<Point>& points, const Triangle& t)
{
  return { ToInexact(points[t[0]]), ToInexact(points[t[1]]), ToInexact(points[t[2]]) };
}

/** Ends CGAL's search, which goes on otherwise. */
struct EnoughPairs
{
};

} // namespace

std::vector<std::pair<int, int>> FindIntersections(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles, std::size_t most)
{
  std::vector<IndexedBox> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& t : triangles)
  {
    const auto [p, q, r] = CornersOf(points, t);
    const CGAL::Bbox_3 bounds = p.bbox() + q.bbox() + r.bbox();
    boxes.emplace_back(bounds, static_cast<int>(boxes.size()));
  }
  std::vector<std::pair<int, int>> pairs;
  const auto add = [&](int a, int b)
  {
    if (TrianglesCross(CornersOf(points, triangles[a]), CornersOf(points, triangles[b])))
    {
      pairs.push_back(std::minmax(a, b));
      if (pairs.size() >= most)
      {
        throw EnoughPairs();
      }
    }
  };
  try
  {
    VisitPairs(std::move(boxes), add);
  }
  catch (const EnoughPairs&)
  {
    // The list is as long as it may be.
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace carving::helper
