// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/Adjacency.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Attempts/Log.h"
#include "Helper/Attempts/Strategies.h"
#include "Helper/Resolve/Clean.h"
#include "HelperRun.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <random>
#include <unistd.h>

using namespace carving;

namespace
{

HelperRun RunWith(const TriangleMesh& mesh, Conformity conformity, double timeLimit = 0.0)
{
  Job job;
  job.Mesh = mesh;
  job.Conformity = conformity;
  job.TimeLimit = timeLimit;
  job.EnclosingTolerance = 0.0;
  return RunHelper(job);
}

/** TetGen refuses it in any order unless it may put points on the surface. */
TriangleMesh Refused()
{
  std::mt19937_64 random(1);
  return models::Soup(60, random);
}

/** With that it takes many times its patience for this one. */
TriangleMesh RefusedAnyway()
{
  std::mt19937_64 random(2);
  return models::Soup(140, random);
}
constexpr double Patience = 0.5;

/** So near to itself that rounding crossings to doubles makes others, again and again. */
TriangleMesh RefusedUnlessSnapped()
{
  std::mt19937_64 random(1);
  return models::Doubled(models::Sphere(1), 1e-13, random);
}

/** Climbs with a sphere of 80 triangles that TetGen does at once; a line of what is written in the end. */
std::string Climb(double timeLimit, const std::function<std::string(const Reply&)>& describe)
{
  Job job;
  job.Mesh = models::Sphere(1);
  job.Conformity = Conformity::Auto;
  job.TimeLimit = timeLimit;
  Reply reply;
  reply.Result.Surface = Clean(AsResolved(job.Mesh));
  Messages written;
  const auto write = [&]
  {
    written.Add(describe(reply));
    return true;
  };
  EXPECT_TRUE(
    TryStrategies(job, reply, { [](Stage) {}, [](double) { return true; }, [] {}, write }));
  return written.Get();
}

} // namespace

// What TetGen copes with is tetrahedralized by it, exactly.
TEST(Strategies, EndsAtTheFirstRungWhereItCan)
{
  for (const Conformity conformity : { Conformity::Exact, Conformity::Auto })
  {
    const HelperRun run = RunWith(models::Sphere(2), conformity);
    ASSERT_TRUE(run.Succeeded()) << run.Reply.Error;
    EXPECT_EQ(run.Reply.Strategy, "TetGen -pcY");
    EXPECT_EQ(run.Reply.Attempts, "");
    EXPECT_TRUE(run.Reply.Result.Kept.empty());
  }
}

// What it refuses otherwise has points put on its triangles; they stay the same surface, all of faces.
TEST(Strategies, SplitsTrianglesWhereItHasTo)
{
  const HelperRun run = RunWith(Refused(), Conformity::Exact);
  ASSERT_TRUE(run.Succeeded()) << run.Reply.Error;
  EXPECT_EQ(run.Reply.Strategy.find("TetGen -pcM"), 0u) << run.Reply.Strategy;
  EXPECT_EQ(run.Reply.Limits, ""); // no higher one would have been of use
  // The last of the six orders that the documentation of Conformity promises, counted from 0.
  EXPECT_NE(run.Reply.Attempts.find("order 5"), std::string::npos);
  const Tetrahedralization& result = run.Reply.Result;
  EXPECT_TRUE(result.Kept.empty());
  std::vector<int> uses(result.Surface.Facets.size(), 0);
  for (const auto& constraints : result.Constraints)
  {
    for (const int facet : constraints)
    {
      if (facet >= 0)
      {
        ++uses[facet];
      }
    }
  }
  EXPECT_EQ(std::count(uses.begin(), uses.end(), 0), 0);
  // Where triangles overlap they count as often as they were given.
  const auto area = [](const std::vector<Point>& points, const Triangle& t)
  { return Length(Cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])); };
  double given = 0.0, split = 0.0;
  const TriangleMesh mesh = Refused();
  for (const Triangle& t : mesh.Triangles)
  {
    given += area(mesh.Points, t);
  }
  for (std::size_t i = 0; i < result.Surface.Facets.size(); ++i)
  {
    split +=
      result.Surface.Multiplicities[i] * area(result.Surface.Points, result.Surface.Facets[i]);
  }
  EXPECT_NEAR(split, given, 1e-9 * given);
}

// What it does not cope with is an error where it has to be exact, and enclosed where it need not.
TEST(Strategies, EndsInEnclosingWhereTetGenFails)
{
  const HelperRun exact = RunWith(RefusedAnyway(), Conformity::Exact, Patience);
  EXPECT_FALSE(exact.Succeeded());
  EXPECT_NE(exact.Reply.Error.find("TetGen -pcM"), std::string::npos) << exact.Reply.Error;
  const HelperRun any = RunWith(RefusedAnyway(), Conformity::Auto);
  ASSERT_TRUE(any.Succeeded()) << any.Reply.Error;
  EXPECT_EQ(any.Reply.Strategy, "Delaunay, enclosing");
  EXPECT_NE(any.Reply.Attempts, "");
}

// By which rung a mesh comes out does not depend on how long the machine is busy with other work.
TEST(Strategies, DoesNotCountTheTimeOfOthers)
{
  const std::string written = Climb(0.0,
    [](const Reply& reply)
    {
      sleep(6); // an attempt at so small a mesh has 5 s
      return reply.Strategy;
    });
  EXPECT_EQ(written, "TetGen -pcY\n");
}

// An attempt that computes for too long is ended, and the limit, on which the result depends, is named.
TEST(Strategies, EndsAttemptsThatComputeTooLong)
{
  const std::string written = Climb(0.0,
    [](const Reply& reply)
    {
      while (reply.Strategy == "TetGen -pcY")
      {
        std::clock();
      }
      return reply.Strategy + ", " + reply.Limits;
    });
  EXPECT_EQ(written, "TetGen -pcY, order 1, TetGen took longer than 5.008 s of processor time\n\n");
}

// A limit of the user's is by the clock; however many attempts it has ended, it is named once.
TEST(Strategies, EndsAttemptsByTheUsersClock)
{
  const std::string written = Climb(0.5,
    [](const Reply& reply)
    {
      while (reply.Strategy != "Delaunay, enclosing")
      {
        pause();
      }
      return reply.Limits;
    });
  EXPECT_EQ(written, "TetGen took longer than 0.5 s\n\n");
}

// What it refuses in any other way has its points moved, by no more than is allowed, and is met then.
TEST(Strategies, SnapsWhereItMay)
{
  EXPECT_FALSE(RunWith(RefusedUnlessSnapped(), Conformity::Exact).Succeeded());
  Job job;
  job.Mesh = RefusedUnlessSnapped();
  for (const Conformity conformity : { Conformity::Exact, Conformity::Auto })
  {
    job.Conformity = conformity;
    job.SnapTolerance = 1e-6;
    const HelperRun run = RunHelper(job);
    ASSERT_TRUE(run.Succeeded()) << run.Reply.Error;
    EXPECT_EQ(run.Reply.Strategy.find("TetGen -pcY, snapped"), 0u) << run.Reply.Strategy;
    EXPECT_NE(run.Reply.Attempts, "");
    EXPECT_TRUE(run.Reply.Result.Kept.empty());
    EXPECT_GT(run.Reply.SnapDistance, 0.0);
    const double diagonal =
      std::sqrt(12.0) * (1.0 + 1e-12); // at most: of the cube around the sphere
    EXPECT_LE(run.Reply.SnapDistance, job.SnapTolerance * diagonal);
    const ResolvedMesh& surface = run.Reply.Result.Surface;
    const TriangleMesh sphere = models::Sphere(1);
    EXPECT_EQ(surface.Facets.size(), sphere.Triangles.size()); // two have become one
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      ASSERT_GE(surface.PointSources[i], 0);
      EXPECT_LE(Length(surface.Points[i] - job.Mesh.Points[surface.PointSources[i]]),
        run.Reply.SnapDistance);
    }
  }
}

// What comes out without is the same whether points may be moved or not.
TEST(Strategies, MovesNothingWithoutNeed)
{
  std::mt19937_64 random(3);
  for (const TriangleMesh& mesh : { models::Sphere(2), models::Soup(12, random) })
  {
    Job job;
    job.Mesh = mesh;
    const HelperRun without = RunHelper(job);
    job.SnapTolerance = 1e-3;
    const HelperRun with = RunHelper(job);
    ASSERT_TRUE(without.Succeeded() && with.Succeeded());
    EXPECT_EQ(with.Reply.Strategy, without.Reply.Strategy);
    EXPECT_EQ(with.Reply.SnapDistance, 0.0);
    EXPECT_EQ(with.Reply.Result.Surface.Points, without.Reply.Result.Surface.Points);
    EXPECT_EQ(with.Reply.Result.Cells, without.Reply.Result.Cells);
  }
}

// Where snapping is of no help either, why is said, and what does without comes next.
TEST(Strategies, GoesOnWhereSnappingFails)
{
  Job job;
  job.Mesh = RefusedUnlessSnapped();
  job.SnapTolerance = 1e-30; // no double near 1 is so near to another
  job.Conformity = Conformity::Auto;
  const HelperRun run = RunHelper(job);
  ASSERT_TRUE(run.Succeeded()) << run.Reply.Error;
  EXPECT_EQ(run.Reply.Strategy, "Delaunay, enclosing");
  EXPECT_EQ(run.Reply.SnapDistance, 0.0);
  EXPECT_NE(run.Reply.Attempts.find("Snapping: on a grid of"), std::string::npos)
    << run.Reply.Attempts;
}

// A tetrahedralization some of whose cells overlap is none, and the next order is tried. (These boxes make
// TetGen give one; random soups found them.)
TEST(Strategies, TakesNoCellsThatOverlap)
{
  Job job;
  job.Mesh = models::Joined(models::Flipped(models::Box({ 0, 1, 2 }, { 3, 3, 5 })),
    models::Joined(models::Box({ 3, 2, 3 }, { 5, 3, 6 }), models::Box({ 1, 3, 3 }, { 3, 4, 4 })));
  job.Initial = InitialApproximation::BoundingBox;
  const HelperRun run = RunHelper(job);
  ASSERT_TRUE(run.Succeeded()) << run.Reply.Error;
  Tetrahedralization result = run.Reply.Result;
  EXPECT_TRUE(FindAdjacency(result)); // no face has three cells
  for (const auto& [a, b, c, d] : result.Cells)
  {
    const std::vector<Point>& p = result.Surface.Points;
    EXPECT_GT(SixVolume(p[a], p[b], p[c], p[d]), 0.0);
  }
}

// A mesh without volume is no matter of rungs.
TEST(Strategies, SaysWhatNoRungCanHelp)
{
  for (const Conformity conformity : { Conformity::Exact, Conformity::Enclosing, Conformity::Auto })
  {
    const HelperRun run = RunWith(models::Sheet(2), conformity);
    EXPECT_FALSE(run.Succeeded());
    EXPECT_NE(run.Reply.Error.find("in one plane"), std::string::npos) << run.Reply.Error;
  }
}
