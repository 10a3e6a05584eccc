// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/Subdivision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace carving;
using namespace carving::helper;

namespace
{

/**
 * Two triangles in the plane z = 0 that share an edge, and a third triangle on that edge in another
 * plane.
 */
ResolvedMesh ThreeOnAnEdge()
{
  ResolvedMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 0.9, 0 }, { 0.6, -0.8, 0 }, { 0.4, 0.1, 1 } };
  mesh.Facets = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } };
  return mesh;
}

std::vector<int> PartsOf(const Subdivision& parts, int parent)
{
  std::vector<int> result;
  for (std::size_t i = 0; i < parts.GetParts().size(); ++i)
  {
    if (parts.GetParts()[i].Parent == parent)
    {
      result.push_back(static_cast<int>(i));
    }
  }
  return result;
}

Point NormalOf(const std::array<Point, 3>& t)
{
  return Cross(t[1] - t[0], t[2] - t[0]);
}

/**
 * Splits parts and edges at random points; returns the parts that exist according to the changes.
 */
std::set<int> SplitAtRandom(Subdivision& parts, int times, std::mt19937_64& random)
{
  std::set<int> alive = { 0, 1, 2 };
  const auto draw = [&random] { return 0.2 + 0.6 * static_cast<double>(random() % 1000) / 1000.0; };
  for (int i = 0; i < times; ++i)
  {
    const int part = *std::next(alive.begin(), random() % alive.size());
    const auto t = parts.GetCorners(part);
    const Triangle corners = parts.GetParts()[part].Corners;
    const bool onEdge = random() % 3 == 0;
    const double u = draw(), v = onEdge ? 0.0 : (1.0 - u) * draw();
    const int vertex = parts.AddPoint(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
    Subdivision::Change change;
    if (onEdge)
    {
      parts.SplitEdge(corners[0], corners[1], vertex, change);
    }
    else
    {
      parts.SplitPart(part, vertex, change);
    }
    parts.Legalize(vertex, change);
    for (const int gone : change.Gone)
    {
      EXPECT_EQ(alive.erase(gone), 1u);
    }
    for (const int made : change.Made)
    {
      EXPECT_TRUE(alive.insert(made).second);
    }
  }
  return alive;
}

} // namespace

// After any splits, the parts of a triangle cover it once and have its orientation.
TEST(Subdivision, CoversEveryTriangleOnce)
{
  std::mt19937_64 random(3);
  const ResolvedMesh mesh = ThreeOnAnEdge();
  Subdivision parts(mesh);
  const std::set<int> alive = SplitAtRandom(parts, 200, random);
  std::size_t count = 0;
  for (int parent = 0; parent < 3; ++parent)
  {
    const auto& [a, b, c] = mesh.Facets[parent];
    const Point whole = NormalOf({ mesh.Points[a], mesh.Points[b], mesh.Points[c] });
    double area = 0.0;
    for (const int part : PartsOf(parts, parent))
    {
      EXPECT_TRUE(alive.count(part));
      ++count;
      const Point normal = NormalOf(parts.GetCorners(part));
      EXPECT_GT(Dot(normal, whole), 0.0);
      area += Length(normal);
    }
    EXPECT_NEAR(area, Length(whole), 1e-12);
  }
  EXPECT_EQ(count, alive.size());
}

// Parts stay connected: an edge inside a triangle has two parts, and one on the common edge of
// three triangles has three.
TEST(Subdivision, StaysConnected)
{
  std::mt19937_64 random(4);
  Subdivision parts(ThreeOnAnEdge());
  SplitAtRandom(parts, 200, random);
  std::map<std::set<int>, int> uses;
  for (int parent = 0; parent < 3; ++parent)
  {
    for (const int part : PartsOf(parts, parent))
    {
      const Triangle& c = parts.GetParts()[part].Corners;
      for (int i = 0; i < 3; ++i)
      {
        ++uses[{ c[i], c[(i + 1) % 3] }];
      }
    }
  }
  const std::vector<Point>& points = parts.GetPoints();
  for (const auto& [edge, count] : uses)
  {
    const Point &a = points[*edge.begin()], &b = points[*edge.rbegin()];
    const bool common = a[1] == 0.0 && a[2] == 0.0 && b[1] == 0.0 && b[2] == 0.0;
    if (common)
    {
      EXPECT_EQ(count, 3);
    }
    else
    {
      EXPECT_LE(count, 2);
    }
  }
}

// The circumcircle of a part contains no vertex of another part of the same triangle.
TEST(Subdivision, IsDelaunayInThePlane)
{
  std::mt19937_64 random(5);
  Subdivision parts(ThreeOnAnEdge());
  SplitAtRandom(parts, 150, random);
  for (int parent = 0; parent < 2; ++parent)
  {
    const std::vector<int> all = PartsOf(parts, parent);
    std::set<int> vertices;
    for (const int part : all)
    {
      const Triangle& c = parts.GetParts()[part].Corners;
      vertices.insert(c.begin(), c.end());
    }
    for (const int part : all)
    {
      // The circumcenter in the plane z = 0, which contains both triangles.
      const auto [a, b, c] = parts.GetCorners(part);
      const Point u = b - a, v = c - a;
      const double d = 2.0 * (u[0] * v[1] - u[1] * v[0]);
      const Point center = { a[0] + (v[1] * Dot(u, u) - u[1] * Dot(v, v)) / d,
        a[1] + (u[0] * Dot(v, v) - v[0] * Dot(u, u)) / d, 0.0 };
      const double radius = Length(a - center);
      for (const int vertex : vertices)
      {
        EXPECT_GE(Length(parts.GetPoints()[vertex] - center), radius * (1.0 - 1e-6));
      }
    }
  }
}
