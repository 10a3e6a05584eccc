// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Imprint.h"
#include "Helper/Resolve/Intersections.h"
#include "Helper/Resolve/Resolve.h"
#include "Helper/Resolve/Snap.h"
#include "RandomModels.h"
#include "Resolved.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

using namespace carving;
using namespace carving::helper;

namespace
{

constexpr double Spacing = 1.0 / 1024.0;

const int NumberOfAssemblies = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_ASSEMBLIES", 30);

bool OnGrid(const Point& p)
{
  return std::all_of(p.begin(), p.end(),
    [](double coordinate) { return coordinate / Spacing == std::floor(coordinate / Spacing); });
}

/** The largest distance between a point of the mesh and its source. */
double FarthestMove(const TriangleMesh& given, const ResolvedMesh& mesh)
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    if (mesh.PointSources[i] >= 0)
    {
      farthest = std::max(farthest, Length(mesh.Points[i] - given.Points[mesh.PointSources[i]]));
    }
  }
  return farthest;
}

/** Two plates that cross, with flush tops and bottoms. */
TriangleMesh FlushPlates()
{
  return models::Joined(models::Box({ -1.0, -0.3, 0.0 }, { 1.0, 0.3, 0.1 }),
    models::Box({ -0.3, -1.0, 0.0 }, { 0.3, 1.0, 0.1 }));
}

/** The same mesh with its points in another order, which begins with the given one. */
TriangleMesh BeginningWith(int first, TriangleMesh mesh)
{
  const int count = static_cast<int>(mesh.Points.size());
  std::rotate(mesh.Points.begin(), mesh.Points.begin() + first, mesh.Points.end());
  for (Triangle& t : mesh.Triangles)
  {
    for (int& corner : t)
    {
      corner = (corner + count - first) % count;
    }
  }
  return mesh;
}

/** Expects that resolving what touches leaves no crossing, this area, and all points in place. */
void ExpectResolved(const TriangleMesh& given, double area)
{
  constexpr double tolerance = 1e-12;
  SnappedMesh snapped;
  ASSERT_EQ(SnapTouching(Clean(AsResolved(given)), tolerance, {}, HUGE_VAL, snapped), "");
  EXPECT_EQ(checks::CountCrossings(snapped.Mesh.Points, snapped.Mesh.Facets), 0);
  EXPECT_EQ(FarthestMove(given, snapped.Mesh), 0.0);
  EXPECT_LE(snapped.Distance, 3.0 * tolerance);
  EXPECT_NEAR(AreaOf(snapped.Mesh), area, 1e-9 * area);
}

} // namespace

// The spacing is the largest power of two at which no point moves farther than the tolerance.
TEST(Snap, UsesTheWidestGridForATolerance)
{
  for (const double tolerance : { 1e-9, 0.3, 1.0, 866.1 })
  {
    const double spacing = GridSpacing(tolerance);
    int exponent = 0;
    EXPECT_EQ(std::frexp(spacing, &exponent), 0.5); // a power of two
    EXPECT_LE(spacing * std::sqrt(3.0) / 2.0, tolerance);
    EXPECT_GT(2.0 * spacing * std::sqrt(3.0) / 2.0, tolerance);
  }
}

// Snapping leaves no crossing, all points are on the grid, and the distance bounds every point's
// move.
TEST(Snap, ResolvesRandomMeshesOnTheGrid)
{
  std::mt19937_64 random(1);
  int movedMeshes = 0;
  for (int i = 0; i < 40; ++i)
  {
    const TriangleMesh given =
      i % 2 == 0 ? models::Soup(4 + i / 4, random) : models::MakeRandom(random).Mesh;
    SnappedMesh snapped;
    if (!Snap(Clean(AsResolved(given)), Spacing, {}, HUGE_VAL, snapped).empty())
    {
      continue; // the grid is too coarse
    }
    movedMeshes += snapped.Distance > 0.0;
    const ResolvedMesh& mesh = snapped.Mesh;
    EXPECT_EQ(checks::CountCrossings(mesh.Points, mesh.Facets), 0);
    EXPECT_TRUE(std::all_of(mesh.Points.begin(), mesh.Points.end(), OnGrid));
    EXPECT_GE(snapped.Distance, FarthestMove(given, mesh));
    EXPECT_LT(snapped.Distance, 3.0 * Spacing);
  }
  EXPECT_GT(movedMeshes, 20);
}

// Points move to the nearest grid point: by half a diagonal from the middle of a grid cube, by 0
// from the grid.
TEST(Snap, MovesPointsToTheNearestOfTheGrid)
{
  TriangleMesh given = models::Tetrahedron();
  for (Point& p : given.Points)
  {
    for (double& coordinate : p)
    {
      coordinate = std::round(coordinate);
    }
  }
  SnappedMesh snapped;
  ASSERT_EQ(Snap(Clean(AsResolved(given)), Spacing, {}, HUGE_VAL, snapped), "");
  EXPECT_EQ(snapped.Distance, 0.0);
  EXPECT_EQ(snapped.Mesh.Points, given.Points);
  for (double& coordinate : given.Points[0])
  {
    coordinate += Spacing / 2.0;
  }
  ASSERT_EQ(Snap(Clean(AsResolved(given)), Spacing, {}, HUGE_VAL, snapped), "");
  EXPECT_DOUBLE_EQ(snapped.Distance, Spacing * std::sqrt(3.0) / 2.0);
}

// Surfaces that differ by less than the grid are merged and their multiplicities added.
TEST(Snap, MergesWhatNearlyCoincides)
{
  TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const TriangleMesh given = models::Joined(box, models::Moved(box, { 1e-9, 2e-9, -1e-9 }));
  SnappedMesh snapped;
  ASSERT_EQ(Snap(Clean(AsResolved(given)), Spacing, {}, HUGE_VAL, snapped), "");
  EXPECT_EQ(snapped.Mesh.Facets, Clean(AsResolved(box)).Facets);
  EXPECT_EQ(snapped.Mesh.Multiplicities, std::vector<int>(12, 2));
  EXPECT_EQ(snapped.Mesh.SignedMultiplicities, std::vector<int>(12, 2));
  EXPECT_EQ(snapped.IntersectingPairs, 0);
}

// With too many intersections, nothing is resolved, and the message says why.
TEST(Snap, EndsWhereThereIsTooMuchToResolve)
{
  std::mt19937_64 random(2);
  SnappedMesh snapped;
  const std::string mistake =
    Snap(Clean(AsResolved(models::Soup(30, random))), Spacing, {}, 1.0, snapped);
  EXPECT_NE(mistake.find("pairs of triangles"), std::string::npos) << mistake;
}

// In any rotation, parts whose faces are flush but for rounding are resolved without moving a point
// of theirs. Where faces overlap, one is left.
TEST(SnapTouching, ResolvesFlushFaces)
{
  std::mt19937_64 random(6);
  for (int i = 0; i < NumberOfAssemblies; ++i)
  {
    const TriangleMesh plates = models::Rotated(FlushPlates(), random);
    // Those of both plates, less one of the two squares at the top and at the bottom.
    const double area = 2.0 * 2.0 * (2.0 * 0.6 + 2.0 * 0.1 + 0.6 * 0.1) - 2.0 * 0.6 * 0.6;
    ExpectResolved(plates, area);
  }
}

// Prisms of one axis and radius have flush walls in many directions at once. In any rotation, the
// walls of a shorter one become part of those of a longer one, and its ends become partitions.
TEST(SnapTouching, ResolvesFlushWallsInManyDirections)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> height(0.1, 1.9);
  for (int i = 0; i < NumberOfAssemblies; ++i)
  {
    const int sides = 3 + static_cast<int>(random() % 20);
    const auto [from, to] = std::minmax({ height(random), height(random) });
    const TriangleMesh prisms = models::Rotated(
      models::Joined(models::Prism(sides, 0.0, 2.0), models::Prism(sides, from, to)), random);
    const double angle = 2.0 * std::acos(-1.0) / sides;
    const double end = sides * std::sin(angle) / 2.0, side = 2.0 * std::sin(angle / 2.0);
    ExpectResolved(prisms, 4.0 * end + sides * side * 2.0);
  }
}

// Random blocks whose faces lie in common planes are resolved in any rotation, too, with the area
// that is left of them where exact arithmetic resolves them before the rotation.
TEST(SnapTouching, ResolvesRotatedBlocks)
{
  std::mt19937_64 random(8);
  for (int i = 0; i < NumberOfAssemblies; ++i)
  {
    const TriangleMesh blocks = models::BoxSoup(2 + i % 8, random);
    ResolvedMesh exact = Clean(AsResolved(blocks));
    int pairs = 0;
    ASSERT_EQ(Resolve(exact, pairs, {}), "");
    ExpectResolved(models::Rotated(blocks, random), AreaOf(exact));
  }
}

// Points that become one have moved, also if all of them stay on their triangles.
TEST(SnapTouching, TellsHowFarPointsMove)
{
  const TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const TriangleMesh given = models::Joined(box, models::Moved(box, { 3e-10, 0, 0 }));
  SnappedMesh snapped;
  ASSERT_EQ(SnapTouching(Clean(AsResolved(given)), 1e-9, {}, HUGE_VAL, snapped), "");
  EXPECT_EQ(snapped.Mesh.Facets.size(), box.Triangles.size());
  EXPECT_NEAR(snapped.Distance, 3e-10, 1e-15);
}

// Two points above each other can both touch an edge of a triangle, while the edge between them is
// perpendicular to the triangle.
TEST(SnapTouching, ResolvesSidesThatAreSeenFromTheirEnds)
{
  constexpr double tolerance = 1e-12, height = 0.75 * tolerance;
  const TriangleMesh given = { { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 0, -height },
                                 { 1, -1, -2 }, { 2, -1, -2 }, { 1, 0, height }, { 1, -1, 2 },
                                 { 2, -1, 2 } },
    { { 0, 1, 2 }, { 3, 4, 5 }, { 6, 7, 8 } } };
  SnappedMesh snapped;
  ASSERT_EQ(SnapTouching(Clean(AsResolved(given)), tolerance, {}, HUGE_VAL, snapped), "");
  EXPECT_TRUE(FindIntersections(snapped.Mesh.Points, snapped.Mesh.Facets).empty());
}

// Points that are closer than the tolerance become one, and others stay.
TEST(Weld, MergesPointsWithinTheTolerance)
{
  TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const std::size_t points = box.Points.size();
  const TriangleMesh given = models::Joined(box, models::Moved(box, { 1e-9, 0, 0 }));
  double distance = 0.0;
  EXPECT_EQ(Weld(Clean(AsResolved(given)), 0.9e-9, distance).Points.size(), 2 * points);
  EXPECT_EQ(distance, 0.0);
  EXPECT_EQ(Weld(Clean(AsResolved(given)), 1.1e-9, distance).Points.size(), points);
  EXPECT_NEAR(distance, 1e-9, 1e-15);
}

// A mesh in which nothing touches and no pair is given is the same after imprinting.
TEST(Imprint, LeavesACleanMeshAlone)
{
  const ResolvedMesh given = Clean(AsResolved(models::Torus(1.0, 0.4, 12, 8)));
  const ResolvedMesh mesh = Imprint(given, {}, 1e-12);
  EXPECT_EQ(mesh.Points, given.Points);
  EXPECT_EQ(mesh.Facets, given.Facets);
}

// A corner that nearly lies on an edge of another triangle splits that edge, one that nearly lies
// on the triangle splits it into three, and two edges that nearly cross get a common point, in
// whatever order the points are.
TEST(Imprint, SplitsAtWhatNearlyTouches)
{
  constexpr double gap = 1e-14, tolerance = 1e-12;
  const TriangleMesh lower = { { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } }, { { 0, 1, 2 } } };
  const auto expectCounts = [&](const TriangleMesh& upper, std::size_t points, std::size_t facets)
  {
    const TriangleMesh both = models::Joined(lower, upper);
    for (int first = 0; first < static_cast<int>(both.Points.size()); ++first)
    {
      const ResolvedMesh mesh =
        Imprint(Clean(AsResolved(BeginningWith(first, both))), {}, tolerance);
      EXPECT_EQ(mesh.Points.size(), points) << first;
      EXPECT_EQ(mesh.Facets.size(), facets) << first;
    }
  };
  expectCounts({ { { 2, gap, gap }, { 2, -2, 2 }, { 3, -2, 2 } }, { { 0, 1, 2 } } }, 6, 3);
  expectCounts({ { { 1, 1, gap }, { 1, 1, 2 }, { 2, 1, 2 } }, { { 0, 1, 2 } } }, 6, 4);
  expectCounts({ { { 2, -1, gap - 1 }, { 2, 1, gap + 1 }, { 2, -1, 3 } }, { { 0, 1, 2 } } }, 7, 4);
}

// With too many intersections, nothing is resolved, and the message says why.
TEST(SnapTouching, EndsWhereThereIsTooMuchToResolve)
{
  std::mt19937_64 random(2);
  SnappedMesh snapped;
  const std::string mistake =
    SnapTouching(Clean(AsResolved(models::Soup(30, random))), 1e-12, {}, 1.0, snapped);
  EXPECT_NE(mistake.find("pairs of triangles"), std::string::npos) << mistake;
}
