// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "ChildWork.h"
#include "Core/Mesh/Adjacency.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Attempts/Messages.h"
#include "Helper/Attempts/Strategies.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Intersections.h"
#include "HelperRun.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>
#include <random>
#include <thread>

using namespace carving;
using namespace carving::helper;

namespace
{

Job MakeJob(const TriangleMesh& mesh, Conformity conformity, double timeLimit = 0.0)
{
  Job job;
  job.Mesh = mesh;
  job.Conformity = conformity;
  job.TimeLimit = timeLimit;
  job.EnclosingTolerance = 0.0;
  return job;
}

/** TetGen fails on it in every order unless it may add points on the surface. */
TriangleMesh NeedsSplitting()
{
  std::mt19937_64 random(1);
  return models::Soup(60, random);
}

constexpr double Patience = 0.5;

/** In place of writing a reply, a test does something and gives a line; an empty one: failure. */
using Writing = std::function<std::string(const Reply&)>;

void Sleep(double seconds)
{
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/** By their names, since the child processes can be further runs of this program. */
const std::map<std::string, Writing> Writings = {
  { "fail in the first order",
    [](const Reply& reply)
    { return reply.Strategy == "TetGen -pcY" ? std::string() : reply.Strategy; } },
  { "hang in the first order",
    [](const Reply& reply)
    {
      while (reply.Strategy == "TetGen -pcY")
      {
        Sleep(1.0);
      }
      return reply.Strategy;
    } },
  { "compute in the first order",
    [](const Reply& reply)
    {
      while (reply.Strategy == "TetGen -pcY")
      {
        std::clock();
      }
      return reply.Strategy + ", " + reply.Limits;
    } },
  { "sleep",
    [](const Reply& reply)
    {
      Sleep(4.0); // longer than the 3 s for an attempt at so small a mesh
      return reply.Strategy;
    } },
  { "hang unless enclosing",
    [](const Reply& reply)
    {
      while (reply.Strategy != "Delaunay, enclosing")
      {
        Sleep(1.0);
      }
      return reply.Limits;
    } },
};
constexpr const char* WritingVariable = "TOPOLOGYCARVING_TEST_WRITING";

/** A host that adds a line to `lines` in place of writing the reply. */
StrategyHost WritingHost(const Reply& reply, Messages& lines)
{
  const Writing write = Writings.at(std::getenv(WritingVariable));
  return { [](Stage) {}, [](double) { return true; }, [] {},
    [&, write]
    {
      const std::string line = write(reply);
      if (!line.empty())
      {
        lines.Add(line);
      }
      return !line.empty();
    } };
}

constexpr const char* Lines = "lines";

/**
 * Tries the strategies on a sphere of 80 triangles, which takes TetGen no time, sheared, so that
 * TetGen comes first. Returns the lines that the named writing gives.
 */
std::string TryOnShearedSphere(double timeLimit, const std::string& writing,
  Strategy strategy = Strategy::Auto, int processes = 1)
{
  Job job;
  job.Processes = processes;
  job.Mesh = models::Sheared(models::Sphere(1));
  job.Conformity = Conformity::Auto;
  job.Strategy = strategy;
  job.TimeLimit = timeLimit;
  Reply reply;
  reply.StageSeconds.assign(NumberOfStages, 0.0);
  reply.Result.Surface = Clean(AsResolved(job.Mesh));
  setenv(WritingVariable, writing.c_str(), 1);
  Messages lines(Lines);
  EXPECT_TRUE(TryStrategies(job, reply, WritingHost(reply, lines)));
  unsetenv(WritingVariable);
  return lines.Get();
}

} // namespace

bool BelongsToStrategies()
{
  return std::getenv(WritingVariable) != nullptr;
}

bool ResumeTestedStrategies(std::istream& in)
{
  Job job;
  Reply reply;
  Messages lines(Lines);
  return ResumeStrategies(in, job, reply, WritingHost(reply, lines));
}

// The first strategy that succeeds is the last one tried.
TEST(Strategies, EndAtTheFirstSuccess)
{
  for (const Conformity conformity : { Conformity::Exact, Conformity::Auto })
  {
    const Reply reply = GetReply(MakeJob(models::Sheared(models::Sphere(2)), conformity));
    EXPECT_EQ(reply.Strategy, "TetGen -pcY");
    EXPECT_EQ(reply.Attempts, "");
    EXPECT_TRUE(reply.Result.Kept.empty());
  }
}

// Recovery comes first on a mesh near Delaunay, unless crossings have been resolved in it.
TEST(Strategies, RecoverMeshesNearDelaunayFirst)
{
  const TriangleMesh sphere = models::Sphere(2);
  const Reply clean = GetReply(MakeJob(sphere, Conformity::Auto));
  EXPECT_EQ(clean.Strategy, "Delaunay, recovery");
  EXPECT_EQ(clean.Attempts, "");
  const TriangleMesh crossing = models::Joined(sphere, models::Moved(sphere, { 0.5, 0.2, 0.1 }));
  EXPECT_EQ(GetReply(MakeJob(crossing, Conformity::Auto)).Strategy, "TetGen -pcY");
}

// TetGen comes second where recovery with little effort fails, which the reply does not mention.
TEST(Strategies, TakeTetGenWhereRecoveryGivesUp)
{
  const Reply reply = GetReply(MakeJob(models::CloseSpheres(), Conformity::Auto));
  EXPECT_EQ(reply.Strategy, "TetGen -pcY");
  EXPECT_EQ(reply.Attempts, "");
}

// A free processor for the search for crossings changes nothing but the seconds, whether there are
// crossings or not, and whether TetGen succeeds or not.
TEST(Strategies, DoNotDependOnTheNumberOfProcesses)
{
  std::mt19937_64 random(1);
  for (const TriangleMesh& mesh :
    { models::Sphere(2),
      models::Joined(models::Sphere(2), models::Moved(models::Sphere(2), { 0.5, 0.2, 0.1 })),
      models::CloseSpheres(), NeedsSplitting(), models::NearlyEqualSpheres(), models::Lattice(75) })
  {
    Job job = MakeJob(mesh, Conformity::Auto);
    Reply one = GetReply(job);
    job.Processes = 2;
    Reply two = GetReply(job);
    one.StageSeconds = two.StageSeconds;
    EXPECT_EQ(ToBytes(one), ToBytes(two)) << one.Strategy << " or " << two.Strategy;
  }
}

// Threads that share the work of enclosing change nothing but the seconds.
TEST(Strategies, EncloseAlikeWithAnyNumberOfThreads)
{
  std::mt19937_64 random(2);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_SOUPS", 3);
  for (int i = 0; i < count; ++i)
  {
    Job job = MakeJob(models::Soup(100, random), Conformity::Enclosing);
    job.EnclosingTolerance = 0.02;
    Reply one = GetReply(job);
    job.Processes = 3;
    Reply three = GetReply(job);
    one.StageSeconds = three.StageSeconds;
    EXPECT_EQ(ToBytes(one), ToBytes(three));
    EXPECT_GT(one.PointsAdded, 0);
  }
}

// Recovery meets a clean mesh without TetGen, and is an error where it does not meet all of a mesh.
TEST(Strategies, RecoverOnRequest)
{
  Job job = MakeJob(models::Torus(1.0, 0.3, 32, 16), Conformity::Exact);
  job.Strategy = Strategy::Recover;
  const Reply reply = GetReply(job);
  EXPECT_EQ(reply.Strategy, "Delaunay, recovery");
  EXPECT_EQ(reply.Attempts, "");
  EXPECT_EQ(reply.Result.Surface.Facets.size(), job.Mesh.Triangles.size());
  const std::vector<int> uses = checks::CountFaces(reply.Result);
  EXPECT_EQ(std::count(uses.begin(), uses.end(), 0), 0);
  job.Mesh = NeedsSplitting();
  const HelperRun failed = RunHelper(job);
  EXPECT_EQ(failed.Reply.Error.find("Recovery cannot tetrahedralize the mesh."), 0u)
    << failed.Reply.Error;
  EXPECT_EQ(failed.Reply.Error.find("TetGen -"), std::string::npos) << failed.Reply.Error;
}

// Without recovery, TetGen's second order follows the first.
TEST(Strategies, LeaveRecoveryOutOnRequest)
{
  for (const Strategy strategy : { Strategy::TetGen, Strategy::Auto })
  {
    const std::string written = TryOnShearedSphere(0.5, "hang in the first order", strategy);
    EXPECT_EQ(
      written, strategy == Strategy::TetGen ? "TetGen -pcY, order 1\n" : "Delaunay, recovery\n");
  }
}

// Where TetGen finishes but fails, its second order comes before recovery.
TEST(Strategies, TryAnotherOrderWhereTetGenFinishes)
{
  EXPECT_EQ(TryOnShearedSphere(0.0, "fail in the first order"), "TetGen -pcY, order 1\n");
}

// The time of failed attempts is counted by itself.
TEST(Strategies, CountTheTimeOfFailedAttempts)
{
  const auto attempts = static_cast<std::size_t>(Stage::Attempts);
  EXPECT_EQ(GetReply(MakeJob(models::Sphere(2), Conformity::Exact)).StageSeconds[attempts], 0.0);
  EXPECT_GT(GetReply(MakeJob(NeedsSplitting(), Conformity::Exact)).StageSeconds[attempts], 0.0);
}

// Where TetGen fails otherwise, points are added on triangles, whose parts are faces and cover the
// same surface.
TEST(Strategies, SplitTrianglesIfNecessary)
{
  const Reply reply = GetReply(MakeJob(NeedsSplitting(), Conformity::Exact));
  EXPECT_EQ(reply.Strategy.find("TetGen -pc"), 0u) << reply.Strategy;
  EXPECT_EQ(reply.Limits, ""); // a higher limit would not have helped
  // The second of the two orders that the documentation of Conformity states, counted from 0.
  EXPECT_NE(reply.Attempts.find("TetGen -pcY, order 1: "), std::string::npos);
  const Tetrahedralization& result = reply.Result;
  EXPECT_TRUE(result.Kept.empty());
  const std::vector<int> uses = checks::CountFaces(result);
  EXPECT_EQ(std::count(uses.begin(), uses.end(), 0), 0);
  // The area of overlapping triangles counts once per given triangle.
  const auto area = [](const std::vector<Point>& points, const Triangle& t)
  { return Length(Cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])); };
  double given = 0.0, split = 0.0;
  const TriangleMesh mesh = NeedsSplitting();
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

// Auto does not resolve a mesh with more than 5,000 crossings and two per triangle; exact tries it.
TEST(Strategies, ForeseeThatTooManyCrossingsFail)
{
  const TriangleMesh lattice = models::Lattice(75);
  ASSERT_GT(FindIntersections(lattice.Points, lattice.Triangles).size(), 5000u + 2u * 150u);
  const std::string words = "too many to be resolved";
  const Reply any = GetReply(MakeJob(lattice, Conformity::Auto));
  EXPECT_NE(any.Attempts.find(words), std::string::npos) << any.Attempts;
  EXPECT_EQ(any.Strategy, "Delaunay, enclosing");
  const HelperRun exact = RunHelper(MakeJob(lattice, Conformity::Exact, Patience));
  EXPECT_EQ(exact.Reply.Error.find(words), std::string::npos) << exact.Reply.Error;
}

// Auto meets a small mesh of which most triangles cross each other several times.
TEST(Strategies, MeetASmallMeshWithManyCrossings)
{
  const TriangleMesh lattice = models::Lattice(20);
  ASSERT_EQ(FindIntersections(lattice.Points, lattice.Triangles).size(), 400u);
  const Reply reply = GetReply(MakeJob(lattice, Conformity::Auto));
  EXPECT_EQ(reply.Strategy.find("TetGen -pc"), 0u) << reply.Strategy;
  EXPECT_EQ(reply.IntersectingPairs, 400);
}

// Where exact attempts fail, the result is an error with EXACT and an enclosing tetrahedralization
// with AUTO.
TEST(Strategies, EndInEnclosingWhereExactAttemptsFail)
{
  const HelperRun exact = RunHelper(MakeJob(models::NearlyEqualSpheres(), Conformity::Exact));
  EXPECT_FALSE(exact.Succeeded());
  EXPECT_NE(exact.Reply.Error.find("still cross each other"), std::string::npos)
    << exact.Reply.Error;
  const Reply any = GetReply(MakeJob(models::NearlyEqualSpheres(), Conformity::Auto));
  EXPECT_EQ(any.Strategy, "Delaunay, enclosing");
  EXPECT_NE(any.Attempts, "");
}

// The strategy does not depend on the time that the machine spends on other work.
TEST(Strategies, DoNotCountTheTimeOfOthers)
{
  const std::string written = TryOnShearedSphere(0.0, "sleep");
  EXPECT_EQ(written, "TetGen -pcY\n");
}

// An enclosure that was made beside an attempt is dropped where the attempt succeeds.
TEST(Strategies, DropTheEnclosureWhereAnAttemptSucceeds)
{
  const std::string written = TryOnShearedSphere(0.0, "sleep", Strategy::Auto, 2);
  EXPECT_EQ(written, "TetGen -pcY\n");
}

// An attempt that computes too long is ended, and the reply names the limit.
TEST(Strategies, EndAttemptsThatComputeTooLong)
{
  const std::string written = TryOnShearedSphere(0.0, "compute in the first order");
  EXPECT_EQ(written, "Delaunay, recovery, TetGen took longer than 3.008 s of processor time\n\n");
}

// TimeLimit is by the clock, and the reply names it once, however many attempts it ends.
TEST(Strategies, EndAttemptsByTheUsersClock)
{
  const std::string written = TryOnShearedSphere(0.5, "hang unless enclosing");
  EXPECT_EQ(written, "TetGen took longer than 0.5 s\n\n");
}

// Overlapping tetrahedra are rejected, and the next order is tried. (TetGen produces them for these
// boxes, which random soups found.)
TEST(Strategies, RejectOverlappingCells)
{
  Job job;
  job.Mesh = models::Joined(models::Flipped(models::Box({ 0, 1, 2 }, { 3, 3, 5 })),
    models::Joined(models::Box({ 3, 2, 3 }, { 5, 3, 6 }), models::Box({ 1, 3, 3 }, { 3, 4, 4 })));
  job.Initial = InitialApproximation::BoundingBox;
  const Reply reply = GetReply(job);
  EXPECT_NE(reply.Attempts.find("flat or inside out"), std::string::npos) << reply.Attempts;
  Tetrahedralization result = reply.Result;
  EXPECT_TRUE(FindAdjacency(result)); // no face has three cells
  EXPECT_GT(checks::SixVolume(result), 0.0);
}

// No strategy is tried on a mesh without volume.
TEST(Strategies, RefuseMeshesWithoutVolume)
{
  for (const Conformity conformity : { Conformity::Exact, Conformity::Enclosing, Conformity::Auto })
  {
    const HelperRun run = RunHelper(MakeJob(models::Sheet(2), conformity));
    EXPECT_FALSE(run.Succeeded());
    EXPECT_NE(run.Reply.Error.find("in one plane"), std::string::npos) << run.Reply.Error;
  }
}
