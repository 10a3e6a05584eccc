// SPDX-License-Identifier: BSD-3-Clause
// Strategies that move the points of the mesh.
#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Attempts/Patience.h"
#include "HelperRun.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace carving;
using namespace carving::helper;

// Where TetGen fails otherwise, points are moved, by no more than SnapTolerance.
TEST(Strategies, SnapIfAllowed)
{
  Job job;
  job.Mesh = models::NearlyEqualSpheres();
  EXPECT_FALSE(RunHelper(job).Succeeded());
  for (const Conformity conformity : { Conformity::Exact, Conformity::Auto })
  {
    job.Conformity = conformity;
    job.SnapTolerance = 1e-6;
    const Reply reply = GetReply(job);
    EXPECT_EQ(reply.Strategy.find("TetGen -pcY, snapped"), 0u) << reply.Strategy;
    EXPECT_NE(reply.Attempts, "");
    EXPECT_TRUE(reply.Result.Kept.empty());
    EXPECT_GT(reply.SnapDistance, 0.0);
    const double diagonal =
      std::sqrt(12.0) * (1.0 + 1e-12); // at most that of the cube around the sphere
    EXPECT_LE(reply.SnapDistance, job.SnapTolerance * diagonal);
    const ResolvedMesh& surface = reply.Result.Surface;
    const TriangleMesh sphere = models::Sphere(1);
    EXPECT_EQ(surface.Facets.size(), sphere.Triangles.size()); // the two surfaces are merged
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      ASSERT_GE(surface.PointSources[i], 0);
      EXPECT_LE(
        Length(surface.Points[i] - job.Mesh.Points[surface.PointSources[i]]), reply.SnapDistance);
    }
  }
}

// SnapTolerance changes nothing where TetGen succeeds without it.
TEST(Strategies, MoveNothingUnnecessarily)
{
  std::mt19937_64 random(3);
  for (const TriangleMesh& mesh : { models::Sphere(2), models::Soup(12, random) })
  {
    Job job;
    job.Mesh = mesh;
    const Reply without = GetReply(job);
    job.SnapTolerance = 1e-3;
    const Reply with = GetReply(job);
    EXPECT_EQ(with.Strategy, without.Strategy);
    EXPECT_EQ(with.SnapDistance, 0.0);
    EXPECT_EQ(with.Result.Surface.Points, without.Result.Surface.Points);
    EXPECT_EQ(with.Result.Cells, without.Result.Cells);
  }
}

// Parts whose faces are flush but for rounding are met in any rotation, and their points stay.
TEST(Strategies, MeetFlushParts)
{
  std::mt19937_64 random(9);
  const TriangleMesh plates = models::Joined(models::Box({ -1.0, -0.3, 0.0 }, { 1.0, 0.3, 0.1 }),
    models::Box({ -0.3, -1.0, 0.0 }, { 0.3, 1.0, 0.1 }));
  for (int i = 0; i < 8; ++i)
  {
    Job job;
    job.Mesh = models::Rotated(plates, random);
    job.Conformity = Conformity::Auto;
    job.SnapTolerance = 1e-12;
    const Reply reply = GetReply(job);
    EXPECT_EQ(reply.KeptDistance, 0.0) << reply.Attempts;
    EXPECT_LE(reply.SnapDistance, 1e-12 * Diagonal(job.Mesh.Points));
    const ResolvedMesh& surface = reply.Result.Surface;
    std::size_t given = 0;
    for (std::size_t k = 0; k < surface.Points.size(); ++k)
    {
      const int source = surface.PointSources[k];
      EXPECT_TRUE(source < 0 || surface.Points[k] == job.Mesh.Points[source]);
      given += source >= 0;
    }
    EXPECT_EQ(given, job.Mesh.Points.size());
  }
}

// Soups whose corners are on a grid, but for the roundings of a rotation, are met: TetGen may add
// points on the triangles of the snapped mesh.
TEST(Strategies, MeetSoupsOnARotatedGrid)
{
  constexpr int count = 8;
  std::mt19937_64 random(10);
  int met = 0;
  for (int i = 0; i < count; ++i)
  {
    Job job;
    job.Mesh = models::Rotated(models::GridSoup(120, random), random);
    job.Conformity = Conformity::Auto;
    job.SnapTolerance = 1e-12;
    const Reply reply = GetReply(job);
    met += reply.KeptDistance == 0.0;
    EXPECT_LE(reply.SnapDistance, 1e-12 * Diagonal(job.Mesh.Points));
  }
  EXPECT_GE(met, count - 1); // TetGen may crash on any
}

// Where snapping fails, the reply says why, and the next strategy is tried.
TEST(Strategies, ContinueWhereSnappingFails)
{
  Job job;
  job.Mesh = models::NearlyEqualSpheres();
  job.SnapTolerance = 1e-30; // no two doubles near 1 are so close
  job.Conformity = Conformity::Auto;
  const Reply reply = GetReply(job);
  EXPECT_EQ(reply.Strategy, "Delaunay, enclosing");
  EXPECT_EQ(reply.SnapDistance, 0.0);
  EXPECT_NE(reply.Attempts.find("Snapping on a grid of"), std::string::npos) << reply.Attempts;
}

// Snapping may take the time that the exact attempts have left, and a quarter of their limit even
// if they have left none. EXACT has no limits.
TEST(Strategies, GiveSnappingTheTimeLeft)
{
  constexpr std::size_t facets = 50000;
  Job job;
  job.Conformity = Conformity::Auto;
  const double limit = LimitsOfExact(job, facets).ProcessorSeconds;
  for (const double used : { 0.0, 0.5, 1.0 })
  {
    EXPECT_DOUBLE_EQ(
      LimitsOfSnapped(job, facets, used * limit).ProcessorSeconds, (1.25 - used) * limit);
  }
  EXPECT_DOUBLE_EQ(LimitsOfSnapped(job, facets, 1.1 * limit).ProcessorSeconds, 0.25 * limit);
  job.Conformity = Conformity::Exact;
  EXPECT_EQ(LimitsOfSnapped(job, facets, 100.0).ProcessorSeconds, 0.0);
}
