// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which steps are decimated for which levels.
 */
#include "Session/TighterTrials.h"
#include "Session/TrialPlans.h"
#include "TrialTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace
{

using carving::LevelTarget;
using carving::SimplifiedTarget;

carving::Profile StepsOfFewVertices()
{
  carving::Profile profile = TunnelAtEachStep();
  for (int step = 0; step <= LastStep; ++step)
  {
    profile.Vertices[step] = 2000 + step;
  }
  return profile;
}

/** A trial for 400 vertices within a bound. */
LevelTrial MakeBoundTrial(int step, double error, double bound)
{
  LevelTrial trial = MakeTrial(step, { { 400.0, error } });
  trial.Targets.front().Bound = bound;
  return trial;
}

/** The steps that are tried within bounds for 400 vertices, in ascending order. */
std::vector<int> FindBoundSteps(const std::vector<LevelTrial>& trials)
{
  std::vector<int> steps;
  for (const LevelTrial& trial :
    PlanTighterTrials(StepsOfFewVertices(), MakeTargets({ 400.0 }), trials))
  {
    steps.push_back(trial.Step);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

} // namespace

// Steps between trials are tried for all targets, the coarser ones included.
TEST(TrialPlans, TryStepsBetweenForAllNumbers)
{
  const carving::Profile profile = TunnelAtEachStep();
  const std::vector<SimplifiedTarget> targets = MakeTargets({ 200.0, 500.0, 2000.0 });
  const std::vector<Reached> far = { { 2000, 0.3 }, { 500, 0.3 }, { 200, 0.3 } },
                             close = { { 2000, 0.002 }, { 500, 0.3 }, { 200, 0.3 } };
  const std::vector<LevelTrial> added = PlanTrialsBetween(
    profile, targets, { MakeTrial(0, far), MakeTrial(LastStep, close) }, VerticesOfM);
  ASSERT_FALSE(added.empty());
  for (const LevelTrial& trial : added)
  {
    EXPECT_EQ(trial.Targets.size(), targets.size()) << trial.Step;
  }
}

// Only trials for the same number tell where to try next.
TEST(TrialPlans, TryStepsBetweenTrialsForTheSameNumber)
{
  const std::vector<SimplifiedTarget> targets = MakeTargets({ 200.0 });
  const std::vector<LevelTrial> trials = { MakeTrial(LastStep, { { 200, 0.3 } }),
    MakeTrial(60, { { 2000, 0.1 } }), MakeTrial(0, { { 200, 0.2 } }) };
  const std::vector<LevelTrial> added =
    PlanTrialsBetween(TunnelAtEachStep(), targets, trials, VerticesOfM);
  ASSERT_EQ(added.size(), 1u);
  EXPECT_NEAR(added[0].Step, LastStep / 2, 1);
  // Not if the step has too many vertices.
  EXPECT_TRUE(PlanTrialsBetween(TunnelAtEachStep(), targets, trials, VerticesOfM / 2).empty());
}

// A step is tried again within a bound unless it has many vertices.
TEST(TrialPlans, AreBoundUnlessStepsAreLarge)
{
  carving::Profile profile = TunnelAtEachStep();
  const auto countBound = [&profile](int vertices)
  {
    profile.Vertices[LastStep] = vertices;
    return PlanTighterTrials(
      profile, MakeTargets({ 400.0 }), { MakeTrial(LastStep, { { 400.0, 0.01 } }) })
      .size();
  };
  EXPECT_EQ(countBound(carving::DecimationOptions::ManyVertices), 1u);
  EXPECT_EQ(countBound(carving::DecimationOptions::ManyVertices + 1), 0u);
}

// The next steps that have been tried are tried within a bound, too, however far their results are:
// without a bound, results tell little.
TEST(TrialPlans, AreBoundNextToTheBest)
{
  const std::vector<LevelTrial> trials = { MakeTrial(20, { { 400.0, 0.9 } }),
    MakeTrial(60, { { 400.0, 0.3 } }), MakeTrial(LastStep, { { 400.0, 0.8 } }) };
  EXPECT_EQ(FindBoundSteps(trials), (std::vector<int>{ 20, 60, LastStep }));
}

// Where a neighbor has been tried within a bound, has stuck, or has been found to be too far, the
// step halfway to it takes its place.
TEST(TrialPlans, AreBoundBetweenStepsThatHaveBeenTried)
{
  const LevelTrial best = MakeBoundTrial(60, 0.2, 0.29);
  LevelTrial stuck = MakeTrial(LastStep, { { 400.0, 0.9 } });
  stuck.Result.Surfaces.front().Reached = false;
  const std::vector<int> both = FindBoundSteps({ MakeBoundTrial(20, 0.3, 0.28), best, stuck });
  ASSERT_EQ(both.size(), 2u);
  EXPECT_NEAR(both[0], 40, 1);
  EXPECT_NEAR(both[1], 80, 1);
  LevelTrial far = MakeBoundTrial(20, 0.9, 0.28);
  far.Result.Surfaces.clear();
  DropTargetsIf(far, [](const TrialTarget&) { return true; });
  const std::vector<int> coarser = FindBoundSteps({ far, best });
  ASSERT_EQ(coarser.size(), 1u);
  EXPECT_NEAR(coarser[0], 40, 1);
}

// Bounds are a little below the distance that has been reached.
TEST(TrialPlans, AreBoundBelowTheDistance)
{
  const std::vector<LevelTrial> added =
    PlanTighterTrials(StepsOfFewVertices(), MakeTargets({ 400.0 }),
      { MakeTrial(20, { { 400.0, 0.4 } }), MakeTrial(60, { { 400.0, 0.3 } }) });
  ASSERT_EQ(added.size(), 2u);
  for (const LevelTrial& trial : added)
  {
    EXPECT_LT(trial.Targets.front().Bound, 0.3);
    EXPECT_GT(trial.Targets.front().Bound, 0.27);
  }
}

// A step is tried for all coarser numbers that are sought, too, unless it is the best of another.
TEST(TrialPlans, AreBoundForCoarserNumbersToo)
{
  const std::vector<LevelTrial> trials = { MakeTrial(60, { { 400.0, 0.3 }, { 200.0, 0.4 } }),
    MakeTrial(LastStep, { { 400.0, 0.5 }, { 200.0, 0.6 } }) };
  const std::vector<LevelTrial> added =
    PlanTighterTrials(StepsOfFewVertices(), MakeTargets({ 200.0, 400.0 }), trials);
  ASSERT_EQ(added.size(), 2u);
  EXPECT_EQ(added[0].Targets.size(), 2u);
  EXPECT_EQ(added[1].Targets.size(), 2u);
}

// Bounds end where the last ones have gained nothing.
TEST(TrialPlans, EndWhereBoundsGainNothing)
{
  std::vector<LevelTrial> trials = { MakeBoundTrial(60, 0.2, 0.29) };
  EXPECT_EQ(FindBoundSteps({ trials[0], MakeTrial(20, { { 400.0, 0.9 } }) }).size(), 1u);
  const double bound = PlanTighterTrials(
    StepsOfFewVertices(), MakeTargets({ 400.0 }), { trials[0], MakeTrial(20, { { 400.0, 0.9 } }) })
                         .front()
                         .Targets.front()
                         .Bound;
  for (const int step : { 20, 40, 80 })
  {
    trials.push_back(MakeBoundTrial(step, 0.25, bound));
  }
  EXPECT_EQ(FindBoundSteps(trials), std::vector<int>());
}

// Where too many vertices of the last step touch others, as those of both sides of a sheet do, an
// earlier step of the same topology is tried, and then steps between.
TEST(TrialPlans, TryEarlierStepsWherePartsTouch)
{
  carving::Profile profile = TunnelAtEachStep();
  for (int step = 0; step <= LastStep; ++step)
  {
    profile.Vertices[step] = 100 * (step + 1);
    profile.Tunnels[step] = 0;
  }
  const std::vector<SimplifiedTarget> targets = MakeTargets({ 300.0 });
  std::vector<LevelTrial> trials = { MakeTrial(LastStep, {}) };
  const auto findSteps = [&]
  {
    std::vector<int> steps;
    for (const LevelTrial& trial : PlanTrials(profile, targets, trials))
    {
      steps.push_back(trial.Step);
    }
    return steps;
  };
  EXPECT_EQ(findSteps(), (std::vector<int>{ 2, 0 }));
  trials[0].VerticesThatTouch = 9000;
  trials[0].Dropped = { { 300.0 } };
  EXPECT_EQ(findSteps(), (std::vector<int>{ 49, 2, 0 })); // 5,000 of 10,100 vertices; 300; the hull
  trials.push_back(MakeTrial(49, { { 300, 0.1 } }));
  const std::vector<LevelTrial> between = PlanTrialsBetween(profile, targets, trials, VerticesOfM);
  ASSERT_EQ(between.size(), 1u);
  EXPECT_EQ(between[0].Step, 70); // 7,106 vertices are between 5,000 and 10,100
}

// No step is tried that is more than a quarter farther than an error bound. The coarsest one that
// is left is tried, and so is the coarsest one within the bound.
TEST(TrialPlans, StayNearABound)
{
  std::vector<int> steps;
  for (const LevelTrial& trial :
    PlanTrials(TunnelAtEachStep(), { { LevelTarget::ErrorBound, LastStep, 20.0, {} } }, {}))
  {
    steps.push_back(trial.Step);
  }
  EXPECT_EQ(steps, (std::vector<int>{ 75, 80 }));
}

// Where all steps are farther than an error bound, none is tried.
TEST(TrialPlans, AreEmptyWhereABoundIsOutOfReach)
{
  carving::Profile profile = TunnelAtEachStep();
  for (double& error : profile.Error)
  {
    error += 100.0;
  }
  EXPECT_TRUE(PlanTrials(profile, { { LevelTarget::ErrorBound, LastStep, 20.0, {} } }, {}).empty());
}

// Steps are tried from fine to coarse for numbers, but from coarse to fine for a single error
// bound.
TEST(TrialPlans, StartFromTheStepsThatTellMost)
{
  carving::Profile profile = TunnelAtEachStep();
  for (int step = 0; step <= LastStep; ++step)
  {
    profile.Vertices[step] = 10 + 5 * step;
  }
  const auto expectOrder = [&](LevelTarget type, const auto& isBefore)
  {
    const std::vector<LevelTrial> trials =
      PlanTrials(profile, { { type, LastStep, 90.0, {} } }, {});
    ASSERT_GT(trials.size(), 2u);
    for (std::size_t i = 1; i < trials.size(); ++i)
    {
      EXPECT_TRUE(isBefore(trials[i - 1].Step, trials[i].Step));
    }
  };
  expectOrder(LevelTarget::Vertices, std::greater<int>());
  expectOrder(LevelTarget::ErrorBound, std::less<int>());
}

// The coarsest step within an error bound is tried, also if later ones are farther for a while.
TEST(TrialPlans, TryTheCoarsestStepWithinABound)
{
  carving::Profile profile = TunnelAtEachStep();
  profile.Error[0] = 0.0;
  const std::vector<LevelTrial> trials =
    PlanTrials(profile, { { LevelTarget::ErrorBound, LastStep, 20.0, {} } }, {});
  EXPECT_TRUE(std::any_of(
    trials.begin(), trials.end(), [](const LevelTrial& trial) { return trial.Step == 0; }));
}
