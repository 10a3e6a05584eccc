// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Vector.h"
#include "Core/Solid/Winding.h"
#include "Helper/Resolve/Intersections.h"
#include "Resolved.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace carving;
using namespace carving::helper;

namespace
{

double Area(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles)
  {
    sum += 0.5 * Length(Cross(points[b] - points[a], points[c] - points[a]));
  }
  return sum;
}

/** Triangles with small integer coordinates in the plane z = x + 2 y; many of them overlap. */
TriangleMesh RandomPatchwork(int count, std::mt19937_64& random)
{
  TriangleMesh mesh;
  while (static_cast<int>(mesh.Triangles.size()) < count)
  {
    Triangle t;
    for (int& corner : t)
    {
      const double x = static_cast<double>(random() % 9), y = static_cast<double>(random() % 9);
      corner = static_cast<int>(mesh.Points.size());
      mesh.Points.push_back({ x, y, x + 2.0 * y });
    }
    mesh.Triangles.push_back(t);
  }
  return mesh;
}

/**
 * 1 or -1 if a point lies in a triangle that is counter-clockwise or clockwise, seen along z; 0 if
 * outside.
 */
int SignedCover(const TriangleMesh& mesh, const Triangle& t, const Point& p)
{
  int positive = 0, negative = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Point &a = mesh.Points[t[i]], &b = mesh.Points[t[(i + 1) % 3]];
    const double side = Cross(b - a, p - a)[2];
    positive += side > 0.0;
    negative += side < 0.0;
  }
  return positive == 3 ? 1 : negative == 3 ? -1 : 0;
}

std::vector<std::pair<int, int>> Intersections(const TriangleMesh& mesh)
{
  return FindIntersections(mesh.Points, mesh.Triangles);
}

} // namespace

// The search ends once so many pairs have been found.
TEST(FindIntersections, EndsWithTheWantedNumber)
{
  const TriangleMesh mesh =
    models::Joined(models::Sphere(2), models::Moved(models::Sphere(2), { 0.5, 0.0, 0.0 }));
  const auto all = Intersections(mesh);
  ASSERT_GT(all.size(), 10u);
  const auto some = FindIntersections(mesh.Points, mesh.Triangles, 10);
  EXPECT_EQ(some.size(), 10u);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
}

// Sharing a corner or an edge is no intersection.
TEST(FindIntersections, PassesOverNeighbors)
{
  EXPECT_TRUE(Intersections(models::Sphere(2)).empty());
  EXPECT_TRUE(Intersections(models::Torus(1.0, 0.4, 9, 6)).empty());
}

// Triangles that cross, touch in a point or overlap in their plane intersect.
TEST(FindIntersections, FindsCrossingTouchingAndOverlapping)
{
  const std::vector<Point> lower = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } };
  const std::vector<std::vector<Point>> others = {
    { { 1, 1, -1 }, { 1, 1, 1 }, { 5, 5, 1 } }, // crosses
    { { 1, 1, 0 }, { 1, 1, 1 }, { 2, 1, 1 } },  // touches from above with a corner
    { { 4, 0, 0 }, { 2, 2, 0 }, { 4, 4, 0 } },  // has a corner on the other's edge
    { { 1, 1, 0 }, { 5, 1, 0 }, { 1, 5, 0 } },  // overlaps
  };
  for (const std::vector<Point>& other : others)
  {
    TriangleMesh mesh = { lower, { { 0, 1, 2 }, { 3, 4, 5 } } };
    mesh.Points.insert(mesh.Points.end(), other.begin(), other.end());
    EXPECT_EQ(Intersections(mesh).size(), 1u);
  }
}

// Triangles that share an edge intersect only if one is folded onto the other.
TEST(FindIntersections, FindsAFoldedPair)
{
  EXPECT_EQ(Intersections({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.2, 0.9, 0 } },
                            { { 0, 1, 2 }, { 1, 0, 3 } } })
              .size(),
    1u);
  EXPECT_TRUE(Intersections(
    { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.2, -0.9, 0 } }, { { 0, 1, 2 }, { 1, 0, 3 } } })
                .empty());
}

// Triangles that share a corner and cross are found in either order.
TEST(FindIntersections, FindsACrossingBesideASharedCorner)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, -1 },
    { 1, 1, 1 } };
  EXPECT_EQ(Intersections({ points, { { 0, 1, 2 }, { 0, 3, 4 } } }).size(), 1u);
  EXPECT_EQ(Intersections({ points, { { 0, 3, 4 }, { 0, 1, 2 } } }).size(), 1u);
}

// Boxes whose walls lie on each other are resolved although more pairs cross than the limit allows.
// Others are not.
TEST(Resolve, CopesWithManyWallsInCommonPlanes)
{
  std::mt19937_64 random(9);
  TriangleMesh boxes;
  for (int i = 0; i < 20; ++i)
  {
    Point lower, upper;
    for (int k = 0; k < 3; ++k)
    {
      lower[k] = static_cast<double>(random() % 5);
      upper[k] = lower[k] + 1.0 + static_cast<double>(random() % 3);
    }
    boxes = models::Joined(boxes, models::Box(lower, upper));
  }
  const auto resolve = [](const TriangleMesh& given)
  {
    ResolvedMesh mesh = Clean(AsResolved(given));
    int pairs = 0;
    const std::string mistake = Resolve(mesh, pairs, {}, 300.0);
    EXPECT_GT(pairs, 300);
    EXPECT_TRUE(!mistake.empty() || FindIntersections(mesh.Points, mesh.Facets).empty());
    return mistake;
  };
  EXPECT_EQ(resolve(boxes), "");
  EXPECT_NE(resolve(models::Lattice(20)), "");
}

// Resolving a mesh without intersections changes nothing.
TEST(Resolve, LeavesACleanMeshAlone)
{
  const TriangleMesh given = models::Torus(1.0, 0.4, 9, 6);
  const ResolvedMesh mesh = Resolved(given);
  EXPECT_EQ(mesh.Points, given.Points);
  EXPECT_EQ(mesh.Facets, given.Triangles);
}

// Crossing squares get a common edge and lose no area.
TEST(Resolve, SplitsCrossingSquares)
{
  const TriangleMesh flat = models::Sheet(1);
  TriangleMesh upright = flat;
  for (Point& p : upright.Points)
  {
    p = { p[0], 0.5, p[1] - 0.5 };
  }
  const ResolvedMesh mesh = Resolved(models::Joined(flat, upright));
  EXPECT_NEAR(Area(mesh.Points, mesh.Facets), 2.0, 1e-12);
  EXPECT_EQ(std::count(mesh.PointSources.begin(), mesh.PointSources.end(), -1),
    static_cast<long>(mesh.Points.size()) - 8);
}

// Pieces keep the orientation and multiplicity of their triangle: two crossing solids stay closed
// and have the winding numbers 0, 1 and 2.
TEST(Resolve, KeepsOrientationAndWinding)
{
  const ResolvedMesh mesh = Resolved(
    models::Joined(models::Sphere(2), models::Moved(models::Sphere(1), { 0.7, 0.31, 0.17 })));
  EXPECT_TRUE(IsClosed(mesh));
  EXPECT_NEAR(WindingNumber(mesh, { 0.35, 0.15, 0.08 }), 2.0, 1e-9);
  EXPECT_NEAR(WindingNumber(mesh, { -0.5, 0, 0.1 }), 1.0, 1e-9);
  EXPECT_NEAR(WindingNumber(mesh, { 5, 0, 0 }), 0.0, 1e-9);
}

// Coplanar overlapping triangles share one common part, whose multiplicity is 2.
TEST(Resolve, MergesCoplanarOverlaps)
{
  const ResolvedMesh mesh = Resolved(
    models::Joined(models::Box({ 0, 0, 0 }, { 2, 2, 2 }), models::Box({ 1, 1, 2 }, { 3, 3, 4 })));
  double doubled = 0.0;
  for (std::size_t i = 0; i < mesh.Facets.size(); ++i)
  {
    if (mesh.Multiplicities[i] == 2)
    {
      EXPECT_EQ(mesh.SignedMultiplicities[i], 0); // the boxes face each other
      doubled += Area(mesh.Points, { mesh.Facets[i] });
    }
  }
  EXPECT_NEAR(doubled, 1.0, 1e-12);
  EXPECT_TRUE(IsClosed(mesh));
}

// A corner on an edge of another triangle splits that edge, so that no T-junction remains.
TEST(Resolve, SplitsEdgesAtTJunctions)
{
  const ResolvedMesh mesh = Resolved(
    { { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 0, 0 }, { 0.5, -1, 0 }, { 1.5, -1, 0 } },
      { { 0, 1, 2 }, { 3, 4, 5 } } });
  EXPECT_EQ(mesh.Facets.size(), 3u);
  EXPECT_EQ(mesh.Points.size(), 6u);
}

// Many triangles through nearly one line are resolved.
TEST(Resolve, CopesWithManyTrianglesThroughOneLine)
{
  TriangleMesh fan;
  for (int i = 0; i < 12; ++i)
  {
    const double angle = 0.5 * i;
    const int at = static_cast<int>(fan.Points.size());
    fan.Points.insert(fan.Points.end(),
      { { std::cos(angle), std::sin(angle), -1.0 - 0.01 * i },
        { std::cos(angle), std::sin(angle), 1.0 + 0.02 * i },
        { -std::cos(angle), -std::sin(angle), 0.1 * i } });
    fan.Triangles.push_back({ at, at + 1, at + 2 });
  }
  Resolved(fan);
}

// The pieces of overlapping coplanar triangles cover them exactly, with the right multiplicities.
TEST(Resolve, CountsTrianglesThatCoverEachOther)
{
  std::mt19937_64 random(13);
  for (int i = 0; i < 20; ++i)
  {
    SCOPED_TRACE("patchwork " + std::to_string(i));
    const TriangleMesh given = RandomPatchwork(2 + static_cast<int>(random() % 30), random);
    const ResolvedMesh mesh = Resolved(given);
    double covered = 0.0;
    for (std::size_t k = 0; k < mesh.Facets.size(); ++k)
    {
      const auto& [a, b, c] = mesh.Facets[k];
      const Point middle = (mesh.Points[a] + mesh.Points[b] + mesh.Points[c]) / 3.0;
      int count = 0, sum = 0;
      for (const Triangle& t : given.Triangles)
      {
        const int sign = SignedCover(given, t, middle);
        count += sign != 0;
        sum += sign;
      }
      const int side = SignedCover({ mesh.Points, {} }, mesh.Facets[k], middle);
      EXPECT_EQ(mesh.Multiplicities[k], count);
      EXPECT_EQ(side * mesh.SignedMultiplicities[k], sum);
      EXPECT_EQ(SignedCover(given, given.Triangles[mesh.FacetSources[k]], middle), side);
      covered += mesh.Multiplicities[k] * Area(mesh.Points, { mesh.Facets[k] });
    }
    const double expected = Area(given.Points, given.Triangles);
    EXPECT_NEAR(covered, expected, 1e-9 * expected);
  }
}

// Triangles that cross a stack of coplanar triangles are resolved with the stack and lose no area.
TEST(Resolve, CutsWhatCrossesAPatchwork)
{
  std::mt19937_64 random(14);
  for (int i = 0; i < 10; ++i)
  {
    SCOPED_TRACE("patchwork " + std::to_string(i));
    const TriangleMesh patchwork = RandomPatchwork(12, random);
    const TriangleMesh across = { { { 0, -1, -9 }, { 9, 8, 5 }, { 4, 5, 40 }, { 8, 0, 0 },
                                    { 0, 8, 30 }, { 1, 1, 0 } },
      { { 0, 1, 2 }, { 3, 4, 5 } } };
    const ResolvedMesh mesh = Resolved(models::Joined(patchwork, across));
    double covered = 0.0;
    for (std::size_t k = 0; k < mesh.Facets.size(); ++k)
    {
      covered += mesh.Multiplicities[k] * Area(mesh.Points, { mesh.Facets[k] });
    }
    const double expected =
      Area(patchwork.Points, patchwork.Triangles) + Area(across.Points, across.Triangles);
    EXPECT_NEAR(covered, expected, 1e-9 * expected);
  }
}
