// SPDX-License-Identifier: BSD-3-Clause
#include "PropertyChecks.h"

#include "Checks.h"
#include "Core/Measure/LevelSelection.h"
#include "Core/Measure/StreamTopology.h"
#include "Core/Surface/SurfaceTopology.h"
#include "Homology.h"
#include "ManifoldCheck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

using namespace carving;

namespace
{

bool HasFolds(const Level<3>& level)
{
  return std::any_of(
    level.Faces.begin(), level.Faces.end(), [](const FaceLife<3>& face) { return face.Fold; });
}

std::vector<char> UsedPoints(const Carved& carved, const Level<3>& level)
{
  std::vector<char> used(carved.Mesh.Surface.Points.size(), 0);
  for (const FaceLife<3>& face : level.Faces)
  {
    for (const int corner : face.Corners)
    {
      used[corner] = 1;
    }
  }
  return used;
}

/** Property 1 of one level: no input vertex is outside. */
void ExpectToEnclose(const Carved& carved, const Level<3>& level, int samples)
{
  const std::vector<Point>& points = carved.Mesh.Surface.Points;
  const std::vector<Triangle> shell = Shell(level);
  EXPECT_TRUE(checks::IsClosed(shell));
  const std::vector<char> used = UsedPoints(carved, level);
  std::vector<int> hidden;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i] && carved.Mesh.Surface.PointSources[i] >= 0)
    {
      hidden.push_back(static_cast<int>(i));
    }
  }
  const std::size_t stride = std::max<std::size_t>(1, hidden.size() / samples);
  for (std::size_t i = 0; i < hidden.size(); i += stride)
  {
    EXPECT_TRUE(checks::Encloses(points, shell, points[hidden[i]]));
  }
}

/** Property 1 of two levels: a line that misses the coarser level also misses the finer one. */
void ExpectSilhouetteToShrink(const Carved& carved, const Level<3>& coarse, const Level<3>& fine,
  int lines, std::mt19937_64& random)
{
  const std::vector<Point>& points = carved.Mesh.Surface.Points;
  std::normal_distribution<double> normal;
  for (int i = 0; i < lines; ++i)
  {
    const Point direction = { normal(random), normal(random), normal(random) };
    // Through a point near the finer level, so that many lines graze it.
    const Triangle& t = fine.Faces[random() % fine.Faces.size()].Corners;
    Point through = points[t[0]];
    for (double& x : through)
    {
      x *= 1.0 + 0.05 * normal(random);
    }
    if (checks::LineHits(points, AllTriangles(fine), through, direction))
    {
      EXPECT_TRUE(checks::LineHits(points, AllTriangles(coarse), through, direction));
    }
  }
}

/** Property 2: the first level is the convex hull of all points, including those of a box. */
void ExpectHull(const Carved& carved, const Level<3>& level)
{
  const std::vector<Point>& points = carved.Mesh.Surface.Points;
  const checks::Hull hull = checks::ConvexHull(points);
  EXPECT_NEAR(
    checks::SixVolume(points, AllTriangles(level)), hull.SixVolume, 1e-9 * hull.SixVolume);
  std::set<Point> vertices;
  for (const FaceLife<3>& face : level.Faces)
  {
    for (const int corner : face.Corners)
    {
      vertices.insert(points[corner]);
    }
  }
  EXPECT_TRUE(
    std::includes(vertices.begin(), vertices.end(), hull.Vertices.begin(), hull.Vertices.end()));
}

/**
 * Property 2: the last level is every triangle of M except those with solid on both sides, once.
 */
void ExpectInput(const Carved& carved, const Level<3>& level)
{
  std::set<int> expected;
  for (std::size_t cell = 0; cell < carved.Mesh.Cells.size(); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int constraint = carved.Mesh.Constraints.Get(cell, f);
      const bool outside = carved.Mesh.Neighbors[cell][f] < 0;
      if (constraint >= 0 &&
        (outside || carved.Regions.Kind(static_cast<int>(cell)) != RegionKind::Solid))
      {
        expected.insert(constraint);
      }
    }
  }
  std::vector<int> found;
  for (const FaceLife<3>& face : level.Faces)
  {
    found.push_back(face.Constraint);
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, std::vector<int>(expected.begin(), expected.end()));
}

/** Property 4, with one and with both sides of folds. Cutting opens no tunnel. */
void ExpectManifold(const Carved& carved, int step)
{
  StoredStream<3> stream = carved.Stored;
  for (const FoldSides folds : { FoldSides::One, FoldSides::Both })
  {
    stream.Folds = folds;
    const Level<3> level = ExtractLevel(stream, step);
    const ManifoldLevel<3> cut = CutIntoManifold(stream, level);
    EXPECT_EQ(checks::FindFaults(level, cut), checks::ManifoldFaults());
    const int genus = checks::Genus(cut), measured = MeasureSurface(cut).Genus;
    EXPECT_TRUE(measured == genus || measured == -1) << measured << " for " << genus; // -1: open
    // One-sided folds are joined with folds only: a tunnel that they close in M is open in the
    // level.
    if (folds == FoldSides::Both || !HasFolds(level))
    {
      EXPECT_EQ(measured, genus);
      EXPECT_LE(genus, carved.Profile.Tunnels[step]);
    }
  }
}

} // namespace

std::vector<Triangle> Shell(const Level<3>& level)
{
  std::vector<Triangle> shell;
  for (const FaceLife<3>& face : level.Faces)
  {
    if (!face.Fold)
    {
      shell.push_back(face.Corners);
    }
  }
  return shell;
}

std::vector<Triangle> AllTriangles(const Level<3>& level)
{
  std::vector<Triangle> triangles;
  for (const FaceLife<3>& face : level.Faces)
  {
    triangles.push_back(face.Corners);
  }
  return triangles;
}

Carved CarveResult(const Tetrahedralization& mesh, const CarveOptions& options, SolidRule rule)
{
  Carved carved = { mesh, Classify(mesh, rule), {}, {}, {} };
  Carve(carved.Mesh, carved.Regions, options, carved.Stream);
  carved.Stored = Store(carved.Mesh, carved.Regions, carved.Stream);
  carved.Profile = ComputeProfile(carved.Stored);
  static_cast<StreamTopology&>(carved.Profile) =
    ComputeTopology(carved.Mesh, carved.Regions, carved.Stream);
  return carved;
}

void ExpectSolid(
  const TriangleMesh& given, const Carved& carved, SolidRule rule, std::mt19937_64& random)
{
  const std::vector<Point>& points = carved.Mesh.Surface.Points;
  const std::vector<Triangle> shell = Shell(ExtractLevel(carved.Stored, carved.Stream.LastStep()));
  std::array<std::uniform_real_distribution<double>, 3> coordinates;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = std::minmax_element(given.Points.begin(), given.Points.end(),
      [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    const double margin = 0.1 * ((*high)[axis] - (*low)[axis]);
    coordinates[axis] =
      std::uniform_real_distribution<double>((*low)[axis] - margin, (*high)[axis] + margin);
  }
  for (int i = 0; i < 100; ++i)
  {
    const Point p = { coordinates[0](random), coordinates[1](random), coordinates[2](random) };
    const checks::Passages passages = checks::CountPassages(given.Points, given.Triangles, p);
    const bool solid = rule == SolidRule::NonzeroWinding
      ? passages.Sum != 0
      : rule == SolidRule::EvenOdd && passages.Count % 2 != 0;
    EXPECT_EQ(checks::CountPassages(points, shell, p).Sum, solid);
  }
}

void ExpectTopology(const Carved& carved, int step)
{
  const auto expected =
    homology::ComputeBettiNumbers(homology::ClosedComplex(carved.Mesh, carved.Stream, step));
  const Profile& profile = carved.Profile;
  EXPECT_EQ((homology::BettiNumbers{
              profile.Components[step], profile.Tunnels[step], profile.Voids[step], 0 }),
    expected)
    << "step " << step;
}

void ExpectProperties(
  const TriangleMesh& given, const Carved& carved, int numberOfLevels, int samples)
{
  std::mt19937_64 random(7);
  const std::vector<Point>& points = carved.Mesh.Surface.Points;
  const std::set<Point> givenPoints(given.Points.begin(), given.Points.end());
  const std::vector<int> steps = SpreadLevels(carved.Profile, numberOfLevels);
  double volume = HUGE_VAL, hullVolume = 0.0;
  int inputVertices = 0;
  Level<3> coarser;
  for (const int step : steps)
  {
    const Level<3> level = ExtractLevel(carved.Stored, step);
    ExpectToEnclose(carved, level, samples);
    ExpectManifold(carved, step);
    EXPECT_EQ(checks::CountCrossings(points, AllTriangles(level)), 0);

    const double newVolume = checks::SixVolume(points, Shell(level));
    hullVolume = std::max(hullVolume, newVolume);
    EXPECT_LE(newVolume, volume);
    volume = newVolume;
    EXPECT_NEAR(6.0 * carved.Profile.Volume[step], newVolume, 1e-10 * hullVolume);

    int newInputVertices = 0, allVertices = 0;
    const std::vector<char> used = UsedPoints(carved, level);
    for (std::size_t i = 0; i < used.size(); ++i)
    {
      allVertices += used[i];
      newInputVertices += used[i] && carved.Mesh.Surface.PointSources[i] >= 0;
      if (used[i] && carved.Mesh.Surface.PointSources[i] >= 0)
      {
        EXPECT_TRUE(givenPoints.count(points[i]));
      }
    }
    EXPECT_GE(newInputVertices, inputVertices);
    inputVertices = newInputVertices;
    EXPECT_EQ(carved.Profile.Vertices[step], allVertices);
    EXPECT_EQ(carved.Profile.Triangles[step], static_cast<int>(level.Faces.size()));

    if (step == 0)
    {
      ExpectHull(carved, level);
    }
    else
    {
      ExpectSilhouetteToShrink(carved, coarser, level, samples, random);
    }
    coarser = level;
  }
  ExpectInput(carved, coarser);
  const auto& [components, voids] = std::tie(carved.Profile.Components, carved.Profile.Voids);
  EXPECT_TRUE(std::is_sorted(components.begin(), components.end()));
  EXPECT_TRUE(std::is_sorted(voids.begin(), voids.end()));
  ExpectTopology(carved, static_cast<int>(random() % components.size()));
}
