// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Enclosing mode: the properties that hold for any triangle soup.
 */
#include "Checks.h"
#include "Core/Measure/LevelSelection.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Resolve/Intersections.h"
#include "HelperRun.h"
#include "ManifoldCheck.h"
#include "PropertyChecks.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace carving;

namespace
{

double DistanceToPlanes(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles, const Point& p)
{
  double least = HUGE_VAL;
  for (const auto& [a, b, c] : triangles)
  {
    const Point normal = Cross(points[b] - points[a], points[c] - points[a]);
    least = std::min(least, std::abs(Dot(normal, p - points[a])) / Length(normal));
  }
  return least;
}

/** Expects that a level contains the corners and centroids of the given triangles. */
void ExpectToEnclose(const TriangleMesh& given, const ResolvedMesh& surface, const Level<3>& level,
  const std::vector<Triangle>& shell, const std::vector<Triangle>& all)
{
  const std::vector<Point>& points = surface.Points;
  std::vector<char> used(given.Points.size(), 0);
  for (const Triangle& t : given.Triangles)
  {
    const Point &a = given.Points[t[0]], &b = given.Points[t[1]], &c = given.Points[t[2]];
    if (Length(Cross(b - a, c - a)) == 0.0)
    {
      continue; // without area: dropped from M
    }
    const Point centroid = (a + b + c) / 3.0;
    for (const int corner : t)
    {
      used[corner] = 1;
    }
    // A centroid on the surface may be outside by a rounding.
    const double rounding = std::max(1e-12, 1e-15 * Length(centroid));
    EXPECT_TRUE(checks::Encloses(points, shell, centroid) ||
      DistanceToPlanes(points, all, centroid) < rounding);
  }
  std::set<int> onLevel;
  for (const FaceLife<3>& face : level.Faces)
  {
    onLevel.insert(face.Corners.begin(), face.Corners.end());
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const int source = surface.PointSources[i];
    if (source >= 0 && used[source])
    {
      EXPECT_TRUE(onLevel.count(static_cast<int>(i)) || checks::Encloses(points, shell, points[i]));
    }
  }
}

/**
 * Expects that every level encloses the soup, is a manifold without crossings, and has no more
 * volume than the one before.
 */
void ExpectEnclosingLevels(const TriangleMesh& given, const Carved& carved)
{
  const std::vector<Point>& points = carved.Mesh.Surface.Points;
  double volume = HUGE_VAL;
  for (const int step : SpreadLevels(carved.Profile, 4))
  {
    SCOPED_TRACE("step " + std::to_string(step));
    const Level<3> level = ExtractLevel(carved.Stored, step);
    const std::vector<Triangle> shell = Shell(level), all = AllTriangles(level);
    EXPECT_EQ(checks::CountCrossings(points, all), 0);
    EXPECT_EQ(
      checks::FindFaults(level, CutIntoManifold(carved.Stored, level)), checks::ManifoldFaults());
    const double newVolume = checks::SixVolume(points, shell);
    EXPECT_LE(newVolume, volume);
    volume = newVolume;
    ExpectTopology(carved, step);
    ExpectToEnclose(given, carved.Mesh.Surface, level, shell, all);
  }
}

/** A soup, and how it is enclosed and carved. */
struct SoupCase
{
  TriangleMesh Mesh;
  InitialApproximation Initial;
  double Tolerance;
  CarveOptions Options;
  double SnapTolerance = 0.0;
};

SoupCase RandomSoup(std::mt19937_64& random)
{
  SoupCase soup;
  soup.Mesh = models::Soup(2 + static_cast<int>(random() % 40), random);
  soup.Initial = static_cast<InitialApproximation>(random() % 2);
  soup.Tolerance = std::array{ 0.0, 0.05, 0.1 }[random() % 3];
  soup.Options.DepthExponent = static_cast<double>(random() % 3);
  soup.Options.CarveExposed = random() % 2 != 0;
  return soup;
}

/** A rotated soup of triangles or boxes on a grid. */
SoupCase FlatSidedSoup(int i, std::mt19937_64& random)
{
  const int n = 2 + static_cast<int>(random() % 20);
  const TriangleMesh aligned = i % 2 ? models::GridSoup(n, random) : models::BoxSoup(n, random);
  return { models::Rotated(aligned, random), InitialApproximation::ConvexHull,
    i % 4 < 2 ? 0.1 : 0.05, {}, i % 3 ? 1e-12 : 0.0 };
}

void ExpectEnclosingLevels(const SoupCase& soup)
{
  Job job;
  job.Mesh = soup.Mesh;
  job.Conformity = Conformity::Enclosing;
  job.EnclosingTolerance = soup.Tolerance;
  job.Initial = soup.Initial;
  job.SnapTolerance = soup.SnapTolerance;
  const Reply reply = GetReply(job);
  ExpectEnclosingLevels(soup.Mesh, CarveResult(reply.Result, soup.Options, SolidRule::SurfaceOnly));
}

} // namespace

// Levels enclose any soup and do not cross themselves.
TEST(Enclose, EnclosesRandomSoups)
{
  std::mt19937_64 random(7);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_SOUPS", 40);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    ExpectEnclosingLevels(RandomSoup(random));
  }
}

// Levels enclose soups so far from the origin that they are only some hundred roundings wide.
TEST(Enclose, EnclosesSoupsOfFewRoundings)
{
  std::mt19937_64 random(11);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_SOUPS", 8);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    SoupCase soup = RandomSoup(random);
    const double distance = std::pow(10.0, 1.0 + static_cast<double>(random() % 5));
    for (Point& p : soup.Mesh.Points)
    {
      p = distance * (Point{ 1.0, -0.5, 0.2 } + 1e-14 * p);
    }
    ExpectEnclosingLevels(soup);
  }
}

// Levels enclose soups with flat sides that are not parallel to the axes, where roundings dent the
// hull, and leave pieces of the soup beyond it.
TEST(Enclose, EnclosesRotatedFlatSides)
{
  std::mt19937_64 random(5);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_SOUPS", 12);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    ExpectEnclosingLevels(FlatSidedSoup(i, random));
  }
}

// Rotated prisms, whose sides are flat and whose ends have their corners on circles, but for
// rounding, are met as a whole, without new vertices.
TEST(Enclose, MeetsRotatedPrisms)
{
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> length(0.1, 20.0);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_MESHES", 10);
  for (int i = 0; i < count; ++i)
  {
    SCOPED_TRACE("prisms " + std::to_string(i));
    const auto prism = [&](double from)
    { return models::Prism(3 + static_cast<int>(random() % 200), from, from + length(random)); };
    const TriangleMesh below = prism(-21.0), above = prism(1.0); // the order of arguments is open
    Job job;
    job.Mesh = models::Rotated(models::Joined(below, above), random);
    job.Conformity = Conformity::Enclosing;
    job.SnapTolerance = 1e-12;
    const Reply reply = GetReply(job);
    EXPECT_EQ(reply.MetShare, 1.0);
    EXPECT_EQ(reply.PointsAdded, 0);
    EXPECT_LE(reply.SnapDistance, 1e-12 * Diagonal(job.Mesh.Points));
  }
}

// Triangles of a flat part that can be recovered are not replaced by others, which would mix their
// cell data. Squares have two Delaunay triangulations.
TEST(Enclose, KeepsTrianglesThatCanBeRecovered)
{
  constexpr int n = 6;
  Job job;
  job.Mesh.Points = models::Sheet(n).Points;
  std::mt19937_64 random(8);
  for (int i = 0; i < n; ++i)
  {
    for (int k = 0; k < n; ++k)
    {
      const int a = (n + 1) * i + k, b = a + n + 1, c = b + 1, d = a + 1;
      const bool isRising = random() % 2 == 0;
      job.Mesh.Triangles.push_back({ a, b, isRising ? c : d });
      job.Mesh.Triangles.push_back({ isRising ? a : b, c, d });
    }
  }
  const int apex = static_cast<int>(job.Mesh.Points.size());
  job.Mesh.Points.push_back({ 0.52, 0.53, -1.0 });
  job.Mesh.Triangles.push_back({ 0, apex, n });
  job.Conformity = Conformity::Enclosing;
  job.SnapTolerance = 1e-12;
  const Reply reply = GetReply(job);
  EXPECT_EQ(reply.MetShare, 1.0);
  EXPECT_EQ(reply.SnapDistance, 0.0);
}

// Levels do not touch themselves at a new vertex in the plane of a dented hull face. Few soups have
// one.
TEST(Enclose, SeesAFaceOfTheHullFromOneSide)
{
  std::mt19937_64 random(4);
  constexpr int before = 23; // soups without
  for (int i = 0; i < before; ++i)
  {
    FlatSidedSoup(i, random);
  }
  ExpectEnclosingLevels(FlatSidedSoup(before, random));
}

// Levels enclose a vertex so close to another one that cutting leaves it out. Few soups have one.
TEST(Enclose, KeepsVerticesThatCuttingLeavesOut)
{
  std::mt19937_64 random(7);
  constexpr int before = 1212; // soups without
  for (int i = 0; i < before; ++i)
  {
    RandomSoup(random);
  }
  ExpectEnclosingLevels(RandomSoup(random));
}

// Levels enclose solids and sheets that overlap, touch or are glued.
TEST(Enclose, EnclosesRandomMeshes)
{
  std::mt19937_64 random(8);
  for (int i = 0; i < 20 && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("mesh " + std::to_string(i));
    const models::RandomModel model = models::MakeRandom(random);
    const Reply reply = GetReply(model.Mesh, Conformity::Enclosing, random() % 2 ? 0.0 : 0.1);
    const auto rule = static_cast<SolidRule>(random() % 3);
    ExpectEnclosingLevels(model.Mesh, CarveResult(reply.Result, {}, rule));
  }
}

// Levels enclose tori that cross each other, whether M itself or the resolved M has been met more.
TEST(Enclose, EnclosesCrossingTori)
{
  std::mt19937_64 random(24);
  std::uniform_real_distribution<double> shift(0.2, 1.0);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_MESHES", 10);
  int resolved = 0;
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i)
  {
    SCOPED_TRACE("tori " + std::to_string(i));
    const auto torus = [&]
    {
      const int n = 6 + static_cast<int>(random() % 10), m = 4 + static_cast<int>(random() % 6);
      const Point translation = { shift(random), shift(random), shift(random) };
      return models::Moved(models::Rotated(models::Torus(1.0, 0.4, n, m), random), translation);
    };
    const TriangleMesh first = torus(), mesh = models::Joined(first, torus());
    const Reply reply = GetReply(mesh, Conformity::Enclosing, 0.05);
    resolved += reply.IntersectingPairs > 0;
    const auto rule = static_cast<SolidRule>(random() % 3);
    ExpectEnclosingLevels(mesh, CarveResult(reply.Result, {}, rule));
  }
  EXPECT_GT(resolved, 0);
  EXPECT_LT(resolved, count);
}

// A cube is met exactly although Delaunay faces use other diagonals of its sides: nothing is kept,
// and everything between two cubes is carved.
TEST(Enclose, TakesOtherDiagonalsForTheSameSide)
{
  const TriangleMesh mesh =
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 3, 0, 0 }, { 4, 1, 1 }));
  const Reply reply = GetReply(mesh, Conformity::Enclosing);
  EXPECT_EQ(std::count(reply.Result.Kept.begin(), reply.Result.Kept.end(), 1), 0);
  const Carved carved = CarveResult(reply.Result);
  const auto shell = Shell(ExtractLevel(carved.Stored, carved.Stream.LastStep()));
  EXPECT_NEAR(checks::SixVolume(carved.Mesh.Surface.Points, shell), 6.0 * 2.0, 1e-12);
  EXPECT_EQ(carved.Profile.Components.back(), 2);
}

// A triangle that pierces nothing is not met if the faces that it lies on reach beyond it.
TEST(Enclose, DoesNotCountCoveredTrianglesAsMet)
{
  TriangleMesh mesh = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  const auto first = static_cast<int>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), { { 0.2, 0.3, 1 }, { 0.8, 0.4, 1 }, { 0.4, 0.8, 1 } });
  mesh.Triangles.push_back({ first, first + 1, first + 2 });
  const Reply reply = GetReply(mesh, Conformity::Enclosing, 0.0); // no vertex may be added
  EXPECT_EQ(std::count(reply.Result.Kept.begin(), reply.Result.Kept.end(), 1), 0);
  EXPECT_LT(reply.MetShare, 1.0);
  for (std::size_t i = 0; i < reply.Result.MetShares.size(); ++i)
  {
    const Triangle& t = mesh.Triangles[reply.Result.Unresolved.FacetSources[i]];
    const bool isOnTop =
      std::all_of(t.begin(), t.end(), [&](int v) { return mesh.Points[v][2] == 1.0; });
    if (isOnTop && t[0] < first)
    {
      EXPECT_EQ(reply.Result.MetShares[i], 0.0); // the other triangle's corners are inside
    }
  }
}

// A hole in a flat side stays a hole, though a Delaunay face would reach over a part of it.
TEST(Enclose, KeepsAHoleInAFlatSide)
{
  // A plate with a corner in the middle of one side, and a long triangular hole near that side.
  const std::vector<std::array<double, 2>> corners = { { 0, 0 }, { 2, 0 }, { 4, 0 }, { 4, 4 },
    { 0, 4 }, { 0.5, 0.5 }, { 3.5, 0.6 }, { 0.6, 0.7 } };
  const std::vector<Triangle> top = { { 0, 1, 5 }, { 1, 6, 5 }, { 1, 2, 6 }, { 2, 3, 6 },
    { 3, 7, 6 }, { 3, 4, 7 }, { 4, 5, 7 }, { 4, 0, 5 } };
  const std::vector<std::array<int, 2>> walls = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 0 },
    { 6, 5 }, { 7, 6 }, { 5, 7 } };
  constexpr int above = 8;
  TriangleMesh plate;
  for (const double z : { 0.0, 1.0 })
  {
    for (const auto& [x, y] : corners)
    {
      plate.Points.push_back({ x, y, z });
    }
  }
  for (const auto& [a, b, c] : top)
  {
    plate.Triangles.push_back({ a + above, b + above, c + above });
    plate.Triangles.push_back({ a, c, b });
  }
  for (const auto& [a, b] : walls)
  {
    plate.Triangles.push_back({ a, b, b + above });
    plate.Triangles.push_back({ a, b + above, a + above });
  }
  constexpr double volume = 16.0 - 0.5 * (3.0 * 0.2 - 0.1 * 0.1);
  for (const TriangleMesh& mesh :
    { plate, models::Sheared(plate), models::Moved(models::Sheared(plate), { 0.1, 0.7, 0.3 }) })
  {
    const Reply reply = GetReply(mesh, Conformity::Enclosing, 0.02);
    EXPECT_EQ(reply.MetShare, 1.0);
    const Carved carved = CarveResult(reply.Result);
    const auto shell = Shell(ExtractLevel(carved.Stored, carved.Stream.LastStep()));
    EXPECT_NEAR(checks::SixVolume(carved.Mesh.Surface.Points, shell), 6.0 * volume, 1e-9);
    EXPECT_EQ(carved.Profile.Tunnels.back(), 1);
  }
}

// A mesh without crossings is met as a whole, and nothing is kept.
TEST(Enclose, MeetsACleanMesh)
{
  const Reply reply = GetReply(models::Torus(1.0, 0.4, 12, 8), Conformity::Enclosing);
  EXPECT_EQ(reply.KeptDistance, 0.0);
  EXPECT_EQ(reply.MetShare, 1.0);
  EXPECT_EQ(std::count(reply.Result.Kept.begin(), reply.Result.Kept.end(), 1), 0);
}

// Two tori that cross each other are met as a whole, too: the resolved mesh is enclosed in place of
// the mesh itself.
TEST(Enclose, MeetsCrossingTori)
{
  const TriangleMesh mesh = models::CrossingTori();
  const Reply reply = GetReply(mesh, Conformity::Enclosing, 0.02);
  const ResolvedMesh& input = reply.Result.GetInput();
  EXPECT_GT(reply.IntersectingPairs, 0);
  EXPECT_TRUE(helper::FindIntersections(input.Points, input.Facets).empty());
  EXPECT_GT(input.Facets.size(), mesh.Triangles.size());
  EXPECT_EQ(std::count(reply.Result.Kept.begin(), reply.Result.Kept.end(), 1), 0);
  EXPECT_EQ(reply.MetShare, 1.0);
}

// Pierced tetrahedra are never carved and have no priority.
TEST(Enclose, KeepsWhatIsPierced)
{
  TriangleMesh mesh = models::Sheet(1);
  mesh = models::Joined(
    mesh, { { { 0.3, 0.2, -1 }, { 0.4, 0.9, 1 }, { 0.7, 0.5, 1.5 } }, { { 0, 1, 2 } } });
  const Reply reply = GetReply(mesh, Conformity::Enclosing);
  const Carved carved = CarveResult(reply.Result, {}, SolidRule::SurfaceOnly);
  int kept = 0;
  for (std::size_t cell = 0; cell < carved.Mesh.Kept.size(); ++cell)
  {
    if (carved.Mesh.Kept[cell])
    {
      ++kept;
      EXPECT_EQ(carved.Stream.Step[cell], carving::Stream::Never);
      EXPECT_TRUE(std::isnan(carved.Stream.Priority[cell]));
    }
  }
  EXPECT_GT(kept, 0);
}

// The rule decides which part of a box inside a box is solid: both boxes, the space between them,
// or none.
TEST(Enclose, KnowsSolidsByEveryRule)
{
  const Reply reply = GetReply(
    models::Joined(models::Box({ 0, 0, 0 }, { 4, 4, 4 }), models::Box({ 1, 1, 1 }, { 3, 3, 3 })),
    Conformity::Enclosing);
  for (const auto& [rule, volume] : { std::pair(SolidRule::NonzeroWinding, 64.0),
         std::pair(SolidRule::EvenOdd, 64.0 - 8.0), std::pair(SolidRule::SurfaceOnly, 0.0) })
  {
    const Carved carved = CarveResult(reply.Result, {}, rule);
    const auto shell = Shell(ExtractLevel(carved.Stored, carved.Stream.LastStep()));
    EXPECT_NEAR(checks::SixVolume(carved.Mesh.Surface.Points, shell), 6.0 * volume, 1e-9);
  }
}
