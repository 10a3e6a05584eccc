// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Core/Mesh/Vector.h"
#include "HelperRun.h"
#include "RealMeshes.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace carving;

namespace
{

double SixVolume(const Tetrahedralization& mesh)
{
  double sum = 0.0;
  for (const auto& [a, b, c, d] : mesh.Cells)
  {
    const std::vector<Point>& p = mesh.Surface.Points;
    const double volume = carving::SixVolume(p[a], p[b], p[c], p[d]);
    EXPECT_GT(volume, 0.0);
    sum += volume;
  }
  return sum;
}

} // namespace

// The tetrahedra fill the convex hull, and each triangle of the input is a face of one or two.
TEST(Helper, FillsTheHull)
{
  const TriangleMesh boxes =
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 2, 0, 0 }, { 3, 1, 1 }));
  const HelperRun run = RunHelper(boxes);
  ASSERT_TRUE(run.Succeeded()) << run.Reply.Error << run.Mistake;
  EXPECT_NEAR(SixVolume(run.Reply.Result), 6.0 * 3.0, 1e-12);
  std::vector<int> faces(run.Reply.Result.Surface.Facets.size(), 0);
  for (const auto& constraints : run.Reply.Result.Constraints)
  {
    for (const int triangle : constraints)
    {
      if (triangle >= 0)
      {
        ++faces[triangle];
      }
    }
  }
  EXPECT_EQ(faces.size(), 24u);
  for (const int count : faces)
  {
    EXPECT_GE(count, 1);
    EXPECT_LE(count, 2);
  }
}

// Points of the input come first and unchanged; Steiner points follow and have no source.
TEST(Helper, KeepsThePointsOfTheInput)
{
  // The Schoenhardt polyhedron cannot be tetrahedralized without a Steiner point.
  TriangleMesh twisted;
  for (int i = 0; i < 6; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * (i % 3) / 3.0 + (i < 3 ? 0.0 : 0.5);
    twisted.Points.push_back({ std::cos(angle), std::sin(angle), i < 3 ? 0.0 : 1.0 });
  }
  twisted.Triangles = { { 0, 2, 1 }, { 3, 4, 5 } };
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    twisted.Triangles.push_back({ i, j, i + 3 });
    twisted.Triangles.push_back({ j, j + 3, i + 3 });
  }
  const HelperRun run = RunHelper(twisted);
  ASSERT_TRUE(run.Succeeded()) << run.Reply.Error << run.Mistake;
  const ResolvedMesh& surface = run.Reply.Result.Surface;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    EXPECT_EQ(surface.PointSources[i], i < 6 ? static_cast<int>(i) : -1);
    if (i < 6)
    {
      EXPECT_EQ(surface.Points[i], twisted.Points[i]);
    }
  }
}

// Crossing solids are resolved first, and the pairs that crossed are counted.
TEST(Helper, ResolvesAndCountsIntersections)
{
  const TriangleMesh mesh =
    models::Joined(models::Sphere(1), models::Moved(models::Sphere(1), { 0.7, 0.31, 0.17 }));
  const HelperRun run = RunHelper(mesh);
  ASSERT_TRUE(run.Succeeded()) << run.Reply.Error << run.Mistake;
  EXPECT_GT(run.Reply.IntersectingPairs, 0);
  EXPECT_EQ(RunHelper(mesh, JobKind::CountIntersections).Reply.IntersectingPairs,
    run.Reply.IntersectingPairs);
}

// So many pairs of the bones cross each other as a count by other means, with exact predicates, finds.
TEST(Helper, CountsTheIntersectionsOfBones)
{
  const TriangleMesh mesh = ReadRealMesh("bones.off");
  const int pairs = RunHelper(mesh, JobKind::CountIntersections).Reply.IntersectingPairs;
  EXPECT_EQ(pairs, checks::CountCrossings(mesh.Points, mesh.Triangles));
  EXPECT_GT(pairs, 100);
}

// In a box grown by a hundredth of its diagonal, the tetrahedra fill that, and even a flat mesh has a
// volume to carve.
TEST(Helper, FillsAGrownBox)
{
  const double margin = 0.01 * std::sqrt(3.0);
  Job job;
  job.Initial = InitialApproximation::BoundingBox;
  job.Mesh = models::Sphere(1);
  for (Point& p : job.Mesh.Points)
  {
    p = { 0.5 + 0.5 * p[0], 0.5 + 0.5 * p[1], 0.5 + 0.5 * p[2] };
  }
  job.Mesh = models::Joined(job.Mesh, models::Box({ 0, 0, 0 }, { 1, 1, 1 }));
  const HelperRun run = RunHelper(job);
  ASSERT_TRUE(run.Succeeded()) << run.Reply.Error << run.Mistake;
  EXPECT_NEAR(SixVolume(run.Reply.Result), 6.0 * std::pow(1.0 + 2.0 * margin, 3), 1e-9);

  job.Mesh = models::Sheet(2);
  const HelperRun flat = RunHelper(job);
  ASSERT_TRUE(flat.Succeeded()) << flat.Reply.Error << flat.Mistake;
  EXPECT_EQ(flat.Reply.Result.Surface.Points.size(), 9u + 8u);
}

// Counting intersections of a mesh that has none gives 0.
TEST(Helper, CountsNoIntersectionsInACleanMesh)
{
  const HelperRun run = RunHelper(models::Sphere(2), JobKind::CountIntersections);
  ASSERT_TRUE(run.Succeeded());
  EXPECT_EQ(run.Reply.IntersectingPairs, 0);
}

// A flat mesh has no volume to tetrahedralize; the helper says so.
TEST(Helper, RefusesAFlatMesh)
{
  const HelperRun run = RunHelper(models::Sheet(3));
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_NE(run.Reply.Error.find("plane"), std::string::npos);
}

// A mesh all of whose triangles are degenerate has nothing left after cleaning; the helper says so.
TEST(Helper, RefusesAMeshWithoutArea)
{
  const HelperRun run = RunHelper({ { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, { { 0, 1, 2 } } });
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_NE(run.Reply.Error.find("area"), std::string::npos);
}

// Fed with garbage, with half a job or with nothing, the helper answers nothing and exits with 2.
TEST(Helper, RefusesGarbage)
{
  for (const char* garbage : { "", "garbage", "CARVJOB2", "CARVJOB2\1\1\1\1\377\377\377\377" })
  {
    const HelperRun run = RunHelper(std::string(garbage));
    EXPECT_EQ(run.ExitCode, 2);
    EXPECT_TRUE(run.Output.empty());
  }
}
