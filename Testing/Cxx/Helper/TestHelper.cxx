// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "HelperRun.h"
#include "RealMeshes.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace carving;

// The tetrahedra fill the convex hull, and each triangle of the input is a face of one or two of
// them.
TEST(Helper, FillsTheHull)
{
  const TriangleMesh boxes =
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 2, 0, 0 }, { 3, 1, 1 }));
  const Reply reply = GetReply(boxes);
  EXPECT_NEAR(checks::SixVolume(reply.Result), 6.0 * 3.0, 1e-12);
  const std::vector<int> faces = checks::CountFaces(reply.Result);
  EXPECT_EQ(faces.size(), 24u);
  for (const int count : faces)
  {
    EXPECT_GE(count, 1);
    EXPECT_LE(count, 2);
  }
}

// Points of the input come first, unchanged; Steiner points follow and have no source.
TEST(Helper, KeepsThePointsOfTheInput)
{
  // The Schönhardt polyhedron cannot be tetrahedralized without a Steiner point.
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
  const Reply reply = GetReply(twisted);
  const ResolvedMesh& surface = reply.Result.Surface;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    EXPECT_EQ(surface.PointSources[i], i < 6 ? static_cast<int>(i) : -1);
    if (i < 6)
    {
      EXPECT_EQ(surface.Points[i], twisted.Points[i]);
    }
  }
}

// Crossing solids are resolved first, and their intersecting pairs are counted.
TEST(Helper, ResolvesAndCountsIntersections)
{
  const TriangleMesh mesh =
    models::Joined(models::Sphere(1), models::Moved(models::Sphere(1), { 0.7, 0.31, 0.17 }));
  const Reply reply = GetReply(mesh);
  EXPECT_GT(reply.IntersectingPairs, 0);
  EXPECT_EQ(
    RunHelper(mesh, JobKind::CountIntersections).Reply.IntersectingPairs, reply.IntersectingPairs);
}

// The number of intersecting pairs of the bones agrees with an independent, exact count.
TEST(Helper, CountsTheIntersectionsOfBones)
{
  const TriangleMesh mesh = ReadRealMesh("bones.off");
  const int pairs = RunHelper(mesh, JobKind::CountIntersections).Reply.IntersectingPairs;
  EXPECT_EQ(pairs, checks::CountCrossings(mesh.Points, mesh.Triangles));
  EXPECT_GT(pairs, 100);
}

// The tetrahedra fill a bounding box grown by a hundredth of its diagonal, even around a flat mesh.
TEST(Helper, FillsAGrownBox)
{
  const double margin = 0.01 * std::sqrt(3.0);
  Job job;
  job.Initial = InitialApproximation::BoundingBox;
  job.Mesh = models::Sphere(1);
  job.Mesh = models::Joined(
    models::Moved(job.Mesh, { 0.5, 0.5, 0.5 }, 0.5), models::Box({ 0, 0, 0 }, { 1, 1, 1 }));
  const Reply reply = GetReply(job);
  EXPECT_NEAR(checks::SixVolume(reply.Result), 6.0 * std::pow(1.0 + 2.0 * margin, 3), 1e-9);

  job.Mesh = models::Sheet(2);
  const Reply flat = GetReply(job);
  EXPECT_EQ(flat.Result.Surface.Points.size(), 9u + 8u);
}

// A clean mesh has no intersections.
TEST(Helper, CountsNoIntersectionsInACleanMesh)
{
  const HelperRun run = RunHelper(models::Sphere(2), JobKind::CountIntersections);
  ASSERT_TRUE(run.Succeeded());
  EXPECT_EQ(run.Reply.IntersectingPairs, 0);
}

// A flat mesh is refused with a message: it has no volume to tetrahedralize.
TEST(Helper, RefusesAFlatMesh)
{
  const HelperRun run = RunHelper(models::Sheet(3));
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_NE(run.Reply.Error.find("plane"), std::string::npos);
}

// A mesh of degenerate triangles is refused with a message: nothing remains after cleaning.
TEST(Helper, RefusesAMeshWithoutArea)
{
  const HelperRun run = RunHelper({ { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, { { 0, 1, 2 } } });
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_NE(run.Reply.Error.find("area"), std::string::npos);
}

// Given garbage, half a job or nothing, the helper writes nothing and exits with 2.
TEST(Helper, RefusesGarbage)
{
  for (const char* garbage : { "", "garbage", "CARVJOB2", "CARVJOB2\1\1\1\1\377\377\377\377" })
  {
    const HelperRun run = RunHelper(std::string(garbage));
    EXPECT_EQ(run.ExitCode, 2);
    EXPECT_TRUE(run.Output.empty());
  }
}
