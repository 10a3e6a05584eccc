// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Vector.h"
#include "Helper/Cutting/DividePolygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace carving;
using namespace carving::helper;

namespace
{

/** A triangle with a number of vertices on each of its sides. */
Sides MakeSides(
  const std::array<Point, 3>& corners, const std::array<int, 3>& counts, std::vector<Point>& points)
{
  points.assign(corners.begin(), corners.end());
  Sides sides;
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    std::vector<int>& side = sides.emplace_back(1, i);
    for (int k = 1; k <= counts[i]; ++k)
    {
      side.push_back(static_cast<int>(points.size()));
      points.push_back(Between(corners[i], corners[next], k / (counts[i] + 1.0)));
    }
    side.push_back(next);
  }
  return sides;
}

double SignedArea(const Triangle& t, const std::vector<Point>& points)
{
  return 0.5 * Cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])[2];
}

} // namespace

// A triangulated polygon without inner vertices has two triangles less than vertices.
TEST(DividePolygon, CoversATriangleWithVerticesOnItsSides)
{
  std::mt19937_64 random(3);
  const auto draw = [&random] { return static_cast<double>(random() % 1000) / 1000.0; };
  for (int i = 0; i < 200; ++i)
  {
    SCOPED_TRACE("polygon " + std::to_string(i));
    const std::array<Point, 3> corners = { { { 0, 0, 0 }, { 1 + draw(), draw(), 0 },
      { draw(), 1 + draw(), 0 } } };
    const auto count = [&random] { return static_cast<int>(random() % 12); };
    std::vector<Point> points;
    const Sides sides = MakeSides(corners, { count(), count(), count() }, points);
    const std::vector<Triangle> triangles = DividePolygon(sides, points);
    EXPECT_EQ(triangles.size(), points.size() - 2);
    double area = 0.0;
    std::set<int> used;
    for (const Triangle& t : triangles)
    {
      EXPECT_GT(SignedArea(t, points), 1e-6);
      area += SignedArea(t, points);
      used.insert(t.begin(), t.end());
    }
    EXPECT_NEAR(area, SignedArea({ 0, 1, 2 }, points), 1e-12);
    EXPECT_EQ(used.size(), points.size());
  }
}

// Between two long sides with equal vertices, no edge is much longer than the way to the next
// vertex.
TEST(DividePolygon, FillsANeedleAcross)
{
  constexpr int count = 99;
  constexpr double length = 100.0;
  std::vector<Point> points;
  const Sides sides =
    MakeSides({ { { 0, 0, 0 }, { length, 0, 0 }, { 0, 0.1, 0 } } }, { count, count, 0 }, points);
  for (const auto& [a, b, c] : DividePolygon(sides, points))
  {
    EXPECT_LT(Length(points[a] - points[b]), 3.0);
    EXPECT_LT(Length(points[b] - points[c]), 3.0);
    EXPECT_LT(Length(points[c] - points[a]), 3.0);
  }
}

// Rounding may put the vertices of two sides at the same place.
TEST(DividePolygon, LeavesOutTrianglesWithACornerTwice)
{
  std::vector<Point> points;
  Sides sides = MakeSides({ { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 } } }, { 1, 1, 0 }, points);
  sides[1][1] = sides[0][1];
  for (const Triangle& t : DividePolygon(sides, points))
  {
    EXPECT_EQ(std::set<int>(t.begin(), t.end()).size(), 3u);
  }
}
