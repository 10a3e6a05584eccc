// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Snap.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

using namespace carving;
using namespace carving::helper;

namespace
{

constexpr double Spacing = 1.0 / 1024.0;

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

/** Two plates that cross, with flush tops and bottoms, in a random rotation. */
TriangleMesh FlushPlates(std::mt19937_64& random)
{
  const TriangleMesh plates = models::Joined(models::Box({ -1.0, -0.3, 0.0 }, { 1.0, 0.3, 0.1 }),
    models::Box({ -0.3, -1.0, 0.0 }, { 0.3, 1.0, 0.1 }));
  return models::Rotated(plates, random);
}

double AreaOf(const ResolvedMesh& mesh)
{
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.Facets)
  {
    const Point& p = mesh.Points[a];
    area += Length(Cross(mesh.Points[b] - p, mesh.Points[c] - p)) / 2.0;
  }
  return area;
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
TEST(SnapInFrame, ResolvesFlushFaces)
{
  constexpr double tolerance = 1e-12;
  std::mt19937_64 random(6);
  for (int i = 0; i < 30; ++i)
  {
    const TriangleMesh plates = FlushPlates(random);
    const ResolvedMesh given = Clean(AsResolved(plates));
    const std::optional<FlushFrame> frame = FlushFrame::Find(given);
    ASSERT_TRUE(frame);
    SnappedMesh snapped;
    ASSERT_EQ(SnapInFrame(given, *frame, GridSpacing(tolerance), {}, HUGE_VAL, snapped), "");
    EXPECT_EQ(checks::CountCrossings(snapped.Mesh.Points, snapped.Mesh.Facets), 0);
    EXPECT_EQ(FarthestMove(plates, snapped.Mesh), 0.0);
    EXPECT_LE(snapped.Distance, tolerance);
    // Those of both plates, less one of the two squares at the top and at the bottom.
    const double area = 2.0 * 2.0 * (2.0 * 0.6 + 2.0 * 0.1 + 0.6 * 0.1) - 2.0 * 0.6 * 0.6;
    EXPECT_NEAR(AreaOf(snapped.Mesh), area, 1e-9);
  }
}

// A frame is found where faces are parallel to each other, but not to the axes.
TEST(FlushFrame, IsFoundForParallelFaces)
{
  std::mt19937_64 random(7);
  const auto hasFrame = [](const TriangleMesh& mesh)
  { return FlushFrame::Find(Clean(AsResolved(mesh))).has_value(); };
  const TriangleMesh box = models::Box({ 0, 0, 0 }, { 1, 2, 3 });
  EXPECT_TRUE(hasFrame(models::Rotated(box, random)));
  EXPECT_FALSE(hasFrame(box));
  EXPECT_FALSE(hasFrame(models::Rotated(models::Sphere(3), random)));
}

// The directions of the frame are those of a rotated box, in which its edges are parallel to the
// axes, and points return to their places.
TEST(FlushFrame, TurnsFacesToTheAxes)
{
  constexpr double roundings = 1e-14;
  std::mt19937_64 random(8);
  for (int i = 0; i < 20; ++i)
  {
    const TriangleMesh box = models::Rotated(models::Box({ 0, 0, 0 }, { 1, 2, 3 }), random);
    const FlushFrame frame = *FlushFrame::Find(Clean(AsResolved(box)));
    std::array<std::vector<double>, 3> places;
    for (const Point& p : box.Points)
    {
      const Point inFrame = frame.ToFrame(p);
      EXPECT_LE(Length(frame.FromFrame(inFrame) - p), roundings);
      for (int k = 0; k < 3; ++k)
      {
        std::vector<double>& known = places[k];
        const auto isKnown = [&](double x) { return std::abs(x - inFrame[k]) <= roundings; };
        if (std::none_of(known.begin(), known.end(), isKnown))
        {
          known.push_back(inFrame[k]);
        }
      }
    }
    for (const std::vector<double>& known : places)
    {
      EXPECT_EQ(known.size(), 2u); // the planes of two sides
    }
  }
}
