// SPDX-License-Identifier: BSD-3-Clause
#include "LevelSelection.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace carving;

namespace
{

Profile WithVertices(std::vector<int> vertices)
{
  Profile profile;
  profile.Triangles.resize(vertices.size());
  profile.Vertices = std::move(vertices);
  return profile;
}

Profile OneVertexPerStep(int first, int last)
{
  std::vector<int> vertices(last - first + 1);
  std::iota(vertices.begin(), vertices.end(), first);
  return WithVertices(vertices);
}

} // namespace

// The first level is C0, the last M, and vertex counts between them are in geometric progression.
TEST(SpreadLevels, GrowsGeometrically)
{
  // 10, 20, 40, 80, 160 vertices.
  EXPECT_EQ(SpreadLevels(OneVertexPerStep(10, 160), 5), (std::vector<int>{ 0, 10, 30, 70, 150 }));
}

// Where vertex counts do not differ, levels are spread by steps.
TEST(SpreadLevels, FallsBackToSteps)
{
  EXPECT_EQ(SpreadLevels(WithVertices(std::vector<int>(101, 8)), 5),
    (std::vector<int>{ 0, 25, 50, 75, 100 }));
}

// There cannot be more levels than approximations.
TEST(SpreadLevels, GivesAllStepsIfMoreAreWanted)
{
  EXPECT_EQ(SpreadLevels(OneVertexPerStep(4, 6), 10), (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(SpreadLevels(OneVertexPerStep(4, 4), 10), (std::vector<int>{ 0 }));
}

// A single level is M, and two are C0 and M.
TEST(SpreadLevels, KeepsTheEnds)
{
  EXPECT_EQ(SpreadLevels(OneVertexPerStep(10, 20), 1), (std::vector<int>{ 10 }));
  EXPECT_EQ(SpreadLevels(OneVertexPerStep(10, 20), 2), (std::vector<int>{ 0, 10 }));
}

// A target picks the last step within it.
TEST(LastStepWithin, PicksTheLastStepThatFits)
{
  EXPECT_EQ(LastStepWithin({ 4, 5, 5, 7 }, 5), 2);
  EXPECT_EQ(LastStepWithin({ 4, 5, 5, 7 }, 6), 2);
  EXPECT_EQ(LastStepWithin({ 4, 5, 5, 7 }, 100), 3);
}

// Counts can fall again; a step counts only if all before it fit too.
TEST(LastStepWithin, StopsBeforeTheFirstStepThatDoesNotFit)
{
  EXPECT_EQ(LastStepWithin({ 4, 9, 5, 5 }, 6), 0);
}

// A target below the initial approximation cannot be met.
TEST(LastStepWithin, IsMinusOneBelowTheInitialApproximation)
{
  EXPECT_EQ(LastStepWithin({ 4, 5 }, 3), -1);
}
