// SPDX-License-Identifier: BSD-3-Clause
#include "HelperRun.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace carving;

namespace
{

HelperRun RunWith(const TriangleMesh& mesh, Conformity conformity, double timeLimit = 0.0)
{
  Job job;
  job.Mesh = mesh;
  job.Conformity = conformity;
  job.TimeLimit = timeLimit;
  return RunHelper(job);
}

TriangleMesh Refused()
{
  std::mt19937_64 random(1);
  return models::Soup(60, random);
}

} // namespace

// What TetGen copes with is tetrahedralized by it, exactly.
TEST(Ladder, EndsAtTheFirstRungWhereItCan)
{
  for (const Conformity conformity : { Conformity::Exact, Conformity::Auto })
  {
    const HelperRun run = RunWith(models::Sphere(2), conformity);
    ASSERT_TRUE(run.Succeeded()) << run.Reply.Error;
    EXPECT_EQ(run.Reply.Rung, "TetGen -pcY");
    EXPECT_EQ(run.Reply.Attempts, "");
    EXPECT_TRUE(run.Reply.Result.Kept.empty());
  }
}

// What it does not cope with is an error where it has to be exact, and enclosed where it need not.
TEST(Ladder, EndsInEnclosingWhereTetGenFails)
{
  const HelperRun exact = RunWith(Refused(), Conformity::Exact);
  EXPECT_FALSE(exact.Succeeded());
  EXPECT_NE(exact.Reply.Error.find("TetGen"), std::string::npos) << exact.Reply.Error;
  const HelperRun any = RunWith(Refused(), Conformity::Auto);
  ASSERT_TRUE(any.Succeeded()) << any.Reply.Error;
  EXPECT_EQ(any.Reply.Rung, "Delaunay, enclosing");
  EXPECT_NE(any.Reply.Attempts, "");
}

// A limit on time is kept, and said.
TEST(Ladder, KeepsATimeLimit)
{
  const HelperRun run =
    RunWith(models::Joined(models::Sphere(6), models::Moved(models::Sphere(6), { 3, 0, 0 })),
      Conformity::Exact, 0.01);
  EXPECT_FALSE(run.Succeeded());
  EXPECT_NE(run.Reply.Error.find("took longer"), std::string::npos) << run.Reply.Error;
}

// A mesh without volume is no matter of rungs.
TEST(Ladder, SaysWhatNoRungCanHelp)
{
  for (const Conformity conformity : { Conformity::Exact, Conformity::Enclosing, Conformity::Auto })
  {
    const HelperRun run = RunWith(models::Sheet(2), conformity);
    EXPECT_FALSE(run.Succeeded());
    EXPECT_NE(run.Reply.Error.find("in one plane"), std::string::npos) << run.Reply.Error;
  }
}
