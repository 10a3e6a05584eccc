// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/LevelSelection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

// However many levels of however many steps are wanted, each step is looked at a few times only:
// the steps of a long stream come at once, all of them or nearly all.
TEST(SpreadLevels, SpreadsMillionsOfLevels)
{
  const Profile distinct = OneVertexPerStep(10, 1'000'000);
  const Profile equal = WithVertices(std::vector<int>(1'000'000, 8));
  for (const Profile& profile : { distinct, equal })
  {
    const int steps = profile.LastStep() + 1;
    std::vector<int> all(steps);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(SpreadLevels(profile, 10'000'000), all);
    const std::vector<int> nearlyAll = SpreadLevels(profile, steps - 1);
    EXPECT_EQ(static_cast<int>(nearlyAll.size()), steps - 1);
    EXPECT_TRUE(std::is_sorted(nearlyAll.begin(), nearlyAll.end()));
  }
}

// A target picks the last step within it.
TEST(SelectStep, PicksTheLastStepThatFits)
{
  const Profile profile = WithVertices({ 4, 5, 5, 7 });
  EXPECT_EQ(SelectStep(profile, LevelTarget::Vertices, 5).Step, 2);
  EXPECT_EQ(SelectStep(profile, LevelTarget::Vertices, 6).Step, 2);
  EXPECT_EQ(SelectStep(profile, LevelTarget::Vertices, 100).Step, 3);
  EXPECT_EQ(SelectStep(profile, LevelTarget::Vertices, 100).Problem, "");
}

// Counts can fall again; a step counts only if all before it fit too.
TEST(SelectStep, StopsBeforeTheFirstStepThatDoesNotFit)
{
  EXPECT_EQ(SelectStep(WithVertices({ 4, 9, 5, 5 }), LevelTarget::Vertices, 6).Step, 0);
}

// Below the initial approximation a target cannot be met: that is given, and it is said.
TEST(SelectStep, GivesTheInitialApproximationAndAProblemBelowIt)
{
  const SelectedStep selected = SelectStep(WithVertices({ 4, 5 }), LevelTarget::Vertices, 3);
  EXPECT_EQ(selected.Step, 0);
  EXPECT_NE(selected.Problem, "");
}

// A feature size picks the approximation before the first pop of at most that length.
TEST(SelectStep, StopsBeforeTheFirstPriorityOfAFeatureSize)
{
  Profile profile = WithVertices({ 4, 5, 6, 7, 8 });
  SetPriorities<3>(profile, { NAN, 8.0, 3.0, 5.0, 1.0 }, PriorityMeasure::LongestEdge);
  EXPECT_EQ(SelectStep(profile, LevelTarget::FeatureSize, 9.0).Step, 0);
  EXPECT_EQ(SelectStep(profile, LevelTarget::FeatureSize, 8.0).Step, 0);
  EXPECT_EQ(SelectStep(profile, LevelTarget::FeatureSize, 4.0).Step, 1);
  EXPECT_EQ(SelectStep(profile, LevelTarget::FeatureSize, 2.0).Step, 3);
  EXPECT_EQ(SelectStep(profile, LevelTarget::FeatureSize, 0.5).Step, 4);
}

// A step is taken as it is; one that there is not gives the nearest and a problem.
TEST(SelectStep, TakesAStepOrTheNearest)
{
  const Profile profile = WithVertices({ 4, 5, 6 });
  EXPECT_EQ(SelectStep(profile, LevelTarget::Step, 1).Step, 1);
  EXPECT_EQ(SelectStep(profile, LevelTarget::Step, 1).Problem, "");
  EXPECT_EQ(SelectStep(profile, LevelTarget::Step, 9).Step, 2);
  EXPECT_NE(SelectStep(profile, LevelTarget::Step, 9).Problem, "");
}

// Messages write large numbers out.
TEST(SelectStep, WritesLargeNumbersOut)
{
  const std::string problem =
    SelectStep(WithVertices({ 4, 5 }), LevelTarget::Step, 100000000.0).Problem;
  EXPECT_NE(problem.find(" 100000000:"), std::string::npos) << problem;
}

// The range of a target goes from the initial approximation to the most that any step has.
TEST(GetTargetRange, GoesFromTheFirstStepToTheGreatest)
{
  Profile profile = WithVertices({ 4, 5, 7, 6 });
  profile.Triangles = { 4, 6, 10, 8 };
  SetPriorities<3>(profile, { NAN, 8.0, 3.0, 5.0 }, PriorityMeasure::LongestEdge);
  using Range = std::array<double, 2>;
  EXPECT_EQ(GetTargetRange(profile, LevelTarget::Vertices), (Range{ 4.0, 7.0 }));
  EXPECT_EQ(GetTargetRange(profile, LevelTarget::Triangles), (Range{ 4.0, 10.0 }));
  EXPECT_EQ(GetTargetRange(profile, LevelTarget::FeatureSize), (Range{ 3.0, 8.0 }));
  EXPECT_EQ(GetTargetRange(profile, LevelTarget::Step), (Range{ 0.0, 3.0 }));
}

// Tunnels get more and fewer again: a target of them stops before the first step that has more.
TEST(SelectStep, PicksByTunnelsAndComponents)
{
  Profile profile = WithVertices({ 4, 5, 6, 7, 8 });
  profile.Tunnels = { 0, 1, 3, 2, 4 };
  profile.Components = { 1, 1, 2, 2, 5 };
  EXPECT_EQ(SelectStep(profile, LevelTarget::Tunnels, 0).Step, 0);
  EXPECT_EQ(SelectStep(profile, LevelTarget::Tunnels, 2).Step, 1);
  EXPECT_EQ(SelectStep(profile, LevelTarget::Tunnels, 3).Step, 3);
  EXPECT_EQ(SelectStep(profile, LevelTarget::Tunnels, 100).Step, 4);
  EXPECT_EQ(SelectStep(profile, LevelTarget::Components, 2).Step, 3);
  const SelectedStep none = SelectStep(profile, LevelTarget::Components, 0);
  EXPECT_EQ(none.Step, 0);
  EXPECT_NE(none.Problem.find("0 components"), std::string::npos);
  EXPECT_EQ(GetTargetRange(profile, LevelTarget::Tunnels), (std::array<double, 2>{ 0, 4 }));
  EXPECT_EQ(GetTargetRange(profile, LevelTarget::Components), (std::array<double, 2>{ 1, 5 }));
}

// Steps may come closer to the mesh and go farther away again: after the one picked by a bound none
// is farther than that. What no step meets, or what has not been computed, gives the last and says
// so.
TEST(SelectStep, PicksByErrorBound)
{
  Profile profile = WithVertices({ 4, 5, 6, 7, 8 });
  EXPECT_EQ(SelectStep(profile, LevelTarget::ErrorBound, 3).Step, 4);
  EXPECT_NE(SelectStep(profile, LevelTarget::ErrorBound, 3).Problem.find("ComputeError"),
    std::string::npos);
  profile.Error = { 5, 2, 3, 1, 0.5 };
  for (const auto& [bound, step] : { std::pair(5.0, 0), std::pair(3.0, 1), std::pair(2.5, 3),
         std::pair(2.0, 3), std::pair(0.9, 4), std::pair(0.5, 4) })
  {
    EXPECT_EQ(SelectStep(profile, LevelTarget::ErrorBound, bound).Step, step);
    EXPECT_EQ(SelectStep(profile, LevelTarget::ErrorBound, bound).Problem, "");
  }
  const SelectedStep last = SelectStep(profile, LevelTarget::ErrorBound, 0.1);
  EXPECT_EQ(last.Step, 4);
  EXPECT_NE(last.Problem.find("0.5 away"), std::string::npos);
  EXPECT_EQ(GetTargetRange(profile, LevelTarget::ErrorBound), (std::array<double, 2>{ 0.5, 5 }));
}
