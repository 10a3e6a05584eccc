// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which steps are decimated for which levels, and which results are taken.
 */
#include "Session/TighterTrials.h"
#include "Session/TrialPlans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace
{

using carving::LevelTarget;
using carving::SimplifiedTarget;

constexpr int LastStep = 100;
constexpr int VerticesOfM = 10000;
constexpr double Diagonal = 1.0;

/** A number of vertices that a decimated step has reached, and its distance from M. */
using Reached = std::pair<double, double>;

LevelTrial MakeTrial(int step, const std::vector<Reached>& surfaces, double leastVertices = 4.0)
{
  LevelTrial trial;
  trial.LastStep = LastStep;
  trial.Step = step;
  trial.LeastVertices = leastVertices;
  trial.Result.Chain.Vertices = VerticesOfM;
  for (const auto& [vertices, error] : surfaces)
  {
    trial.Targets.push_back({ vertices });
    trial.Result.Surfaces.push_back({ VerticesOfM - static_cast<int>(vertices), true, error });
  }
  return trial;
}

/** The numbers that an earlier step of `own` vertices is tried for after the last one. */
std::vector<double> FindTried(const LevelTrial& last, double own = VerticesOfM)
{
  LevelTrial earlier;
  earlier.LastStep = LastStep;
  earlier.Targets = last.Targets;
  DropTargetsOfLastStep({ last }, Diagonal, own, earlier);
  std::vector<double> numbers;
  for (const TrialTarget& target : earlier.Targets)
  {
    numbers.push_back(target.Value);
  }
  return numbers;
}

std::vector<SimplifiedTarget> MakeTargets(const std::vector<double>& numbers)
{
  std::vector<SimplifiedTarget> targets;
  for (const double number : numbers)
  {
    targets.push_back({ LevelTarget::Vertices, LastStep, number, {} });
  }
  return targets;
}

carving::Profile TunnelAtEachStep()
{
  carving::Profile profile;
  for (int step = 0; step <= LastStep; ++step)
  {
    profile.Vertices.push_back(VerticesOfM - LastStep + step);
    profile.Components.push_back(1);
    profile.Tunnels.push_back(step);
    profile.Voids.push_back(0);
    profile.Error.push_back(LastStep - step);
  }
  return profile;
}

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

using Counts = std::vector<double>;

} // namespace

// Earlier steps are not tried where the last one is about as close as n vertices around a smooth
// surface are: within a few diagonals divided by n.
TEST(LevelTrials, SpareSmoothSurfaces)
{
  EXPECT_EQ(FindTried(MakeTrial(LastStep, { { 2000, 0.002 }, { 500, 0.008 } })), Counts());
}

// Earlier steps are tried where the last one needs most of the vertices for its topology.
TEST(LevelTrials, TryEarlierStepsNearTheLeastNumber)
{
  const LevelTrial last = MakeTrial(LastStep, { { 2000, 0.002 }, { 500, 0.008 } }, 50.0);
  EXPECT_EQ(FindTried(last), Counts({ 500 }));
}

// Earlier steps are tried where the distance grows much faster than the number of vertices falls.
TEST(LevelTrials, TryEarlierStepsWherePitsNeedTheVertices)
{
  const LevelTrial last = MakeTrial(LastStep, { { 2000, 0.002 }, { 1000, 0.012 } });
  EXPECT_EQ(FindTried(last), Counts({ 1000 }));
}

// No earlier step is tried for a number if the last one is close enough even with fewer vertices:
// only the details of M need more.
TEST(LevelTrials, SpareFinerNumbersOfSmoothSurfaces)
{
  const LevelTrial last = MakeTrial(LastStep, { { 2000, 0.006 }, { 1000, 0.008 } });
  EXPECT_EQ(FindTried(last), Counts());
}

// An earlier step is always tried for numbers that it meets without collapses.
TEST(LevelTrials, TryEarlierStepsThatNeedNoCollapses)
{
  const LevelTrial last = MakeTrial(LastStep, { { 2000, 0.006 }, { 1000, 0.008 } });
  EXPECT_EQ(FindTried(last, 2000.0), Counts({ 2000 }));
}

// An earlier step is tried for all numbers below one that it is tried for. If it is best there, the
// coarser levels may not come from a later step.
TEST(LevelTrials, TryAllCoarserNumbersToo)
{
  const LevelTrial last =
    MakeTrial(LastStep, { { 2000, 0.002 }, { 1000, 0.02 }, { 500, 0.02 }, { 200, 0.05 } });
  EXPECT_EQ(FindTried(last), Counts({ 1000, 500, 200 }));
}

// Steps between trials are tried for all targets, the coarser ones included.
TEST(LevelTrials, TryStepsBetweenForAllNumbers)
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
TEST(LevelTrials, TryStepsBetweenTrialsForTheSameNumber)
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
TEST(LevelTrials, AreBoundUnlessStepsAreLarge)
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
TEST(LevelTrials, AreBoundNextToTheBest)
{
  const std::vector<LevelTrial> trials = { MakeTrial(20, { { 400.0, 0.9 } }),
    MakeTrial(60, { { 400.0, 0.3 } }), MakeTrial(LastStep, { { 400.0, 0.8 } }) };
  EXPECT_EQ(FindBoundSteps(trials), (std::vector<int>{ 20, 60, LastStep }));
}

// Where a neighbor has been tried within a bound, has stuck, or has been found to be too far, the
// step halfway to it takes its place.
TEST(LevelTrials, AreBoundBetweenStepsThatHaveBeenTried)
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
TEST(LevelTrials, AreBoundBelowTheDistance)
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
TEST(LevelTrials, AreBoundForCoarserNumbersToo)
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
TEST(LevelTrials, EndWhereBoundsGainNothing)
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

// Of the trials that reach a number, the closest to M comes first. A level with fewer vertices
// stands in for one that is farther from M.
TEST(LevelTrials, AreRankedByDistance)
{
  const std::vector<LevelTrial> trials = { MakeTrial(LastStep, { { 500, 0.03 }, { 200, 0.05 } }),
    MakeTrial(50, { { 500, 0.02 }, { 200, 0.01 } }) };
  const SimplifiedTarget target = MakeTargets({ 500.0 }).front();
  const std::vector<BestTrial> ranked = RankTrials(trials, target);
  ASSERT_EQ(ranked.size(), 2u);
  EXPECT_EQ(ranked[0].Trial, &trials[1]);
  EXPECT_EQ(ranked[0].Surface->Error, 0.01);
  EXPECT_EQ(ranked[1].Surface->Error, 0.03);
}

// Within an error bound, the trial with the fewest vertices comes first; where none is within, the
// closest one.
TEST(LevelTrials, AreRankedByVerticesWithinABound)
{
  const SimplifiedTarget target = { LevelTarget::ErrorBound, LastStep, 0.1, {} };
  std::vector<LevelTrial> trials = { MakeTrial(LastStep, { { 500, 0.04 } }),
    MakeTrial(50, { { 200, 0.08 } }) };
  for (LevelTrial& trial : trials)
  {
    trial.Targets = { { target.Value } };
  }
  EXPECT_EQ(FindBestTrial(trials, target).Trial, &trials[1]);
  for (LevelTrial& trial : trials)
  {
    trial.Result.Surfaces[0].Reached = false;
    trial.Result.Surfaces[0].Error += 0.1;
  }
  EXPECT_EQ(FindBestTrial(trials, target).Trial, &trials[0]);
  EXPECT_EQ(ChooseTrials(trials, { target }).front().Trial, &trials[0]);
}

// A surface for another error bound is taken if it has fewer vertices within the bound, or is
// closer where none is within.
TEST(LevelTrials, ServeOtherBounds)
{
  std::vector<LevelTrial> trials = { MakeTrial(50, { { 400, 0.09 }, { 200, 0.25 } }),
    MakeTrial(LastStep, { { 500, 0.3 } }) };
  trials[0].Targets = { { 0.1 }, { 0.3 } };
  trials[1].Targets = { { 0.2 } };
  trials[1].Result.Surfaces[0].Reached = false;
  const auto find = [&](double bound)
  {
    const BestTrial best = FindBestTrial(trials, { LevelTarget::ErrorBound, LastStep, bound, {} });
    return CountVertices(*best.Trial, *best.Surface);
  };
  EXPECT_EQ(find(0.3), 200);
  EXPECT_EQ(find(0.2), 400);
  EXPECT_EQ(find(0.01), 400);
}

// Where too many vertices of the last step touch others, as those of both sides of a sheet do, an
// earlier step of the same topology is tried, and then steps between.
TEST(LevelTrials, TryEarlierStepsWherePartsTouch)
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
TEST(LevelTrials, StayNearABound)
{
  std::vector<int> steps;
  for (const LevelTrial& trial :
    PlanTrials(TunnelAtEachStep(), { { LevelTarget::ErrorBound, LastStep, 20.0, {} } }, {}))
  {
    steps.push_back(trial.Step);
  }
  EXPECT_EQ(steps, (std::vector<int>{ 75, 80 }));
}

// Steps are tried from fine to coarse for numbers, but from coarse to fine for a single error
// bound.
TEST(LevelTrials, StartFromTheStepsThatTellMost)
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

// A level with fewer vertices than a target allows does not stand in for one that is as far from M
// as the accuracy of distances tells.
TEST(LevelTrials, KeepFinerLevelsAtEqualDistances)
{
  const std::vector<LevelTrial> trials = { MakeTrial(
    LastStep, { { 500, 0.0301 }, { 200, 0.03 } }) };
  const BestTrial best = FindBestTrial(trials, MakeTargets({ 500.0 }).front());
  ASSERT_TRUE(best.Trial);
  EXPECT_EQ(best.Surface->Error, 0.0301);
}

// A surface of another trial that was made for a smaller number has to be clearly closer, too.
TEST(LevelTrials, PreferSurfacesMadeForTheNumber)
{
  const std::vector<SimplifiedTarget> targets = MakeTargets({ 300.0, 800.0 });
  std::vector<LevelTrial> trials = { MakeTrial(50, { { 300, 0.0885 } }),
    MakeTrial(LastStep, { { 800, 0.0886 }, { 300, 0.1 } }) };
  EXPECT_EQ(ChooseTrials(trials, targets)[1].Surface, &trials[1].Result.Surfaces[0]);
  trials[0].Result.Surfaces[0].Error = 0.08;
  EXPECT_EQ(ChooseTrials(trials, targets)[1].Surface, &trials[0].Result.Surfaces[0]);
}

// The coarsest step within an error bound is tried, also if later ones are farther for a while.
TEST(LevelTrials, TryTheCoarsestStepWithinABound)
{
  carving::Profile profile = TunnelAtEachStep();
  profile.Error[0] = 0.0;
  const std::vector<LevelTrial> trials =
    PlanTrials(profile, { { LevelTarget::ErrorBound, LastStep, 20.0, {} } }, {});
  EXPECT_TRUE(std::any_of(
    trials.begin(), trials.end(), [](const LevelTrial& trial) { return trial.Step == 0; }));
}

// No level comes from a later step than a finer one, even if that is closer to M.
TEST(LevelTrials, AreChosenFromStepsInOrder)
{
  const std::vector<SimplifiedTarget> targets = MakeTargets({ 200.0, 500.0 });
  const std::vector<LevelTrial> trials = { MakeTrial(LastStep, { { 500, 0.08 }, { 200, 0.09 } }),
    MakeTrial(50, { { 500, 0.01 }, { 200, 0.1 } }) };
  const std::vector<BestTrial> chosen = ChooseTrials(trials, targets);
  EXPECT_EQ(chosen[0].Trial, &trials[1]);
  EXPECT_EQ(chosen[1].Trial, &trials[1]);
}

// A finer level that is hardly closer does not rule out a coarser one that is much closer.
TEST(LevelTrials, AreChosenForAllLevelsTogether)
{
  const std::vector<SimplifiedTarget> targets = MakeTargets({ 200.0, 500.0 });
  const std::vector<LevelTrial> trials = { MakeTrial(LastStep, { { 500, 0.011 }, { 200, 0.02 } }),
    MakeTrial(50, { { 500, 0.01 }, { 200, 0.1 } }) };
  const std::vector<BestTrial> chosen = ChooseTrials(trials, targets);
  EXPECT_EQ(chosen[0].Trial, &trials[0]);
  EXPECT_EQ(chosen[1].Trial, &trials[0]);
}

// There are as many levels as steps in order allow, also if some targets have no trial.
TEST(LevelTrials, AreChosenForAsManyLevelsAsPossible)
{
  const std::vector<SimplifiedTarget> targets = MakeTargets({ 50.0, 200.0, 500.0, 2000.0 });
  const std::vector<LevelTrial> trials = { MakeTrial(LastStep, { { 200, 0.01 } }),
    MakeTrial(60, { { 500, 0.001 } }), MakeTrial(50, { { 2000, 0.0001 } }) };
  const std::vector<BestTrial> chosen = ChooseTrials(trials, targets);
  EXPECT_EQ(chosen[0].Trial, nullptr);
  for (int i = 1; i < 4; ++i)
  {
    EXPECT_EQ(chosen[i].Trial, &trials[0]) << "a level with fewer vertices stands in";
  }
}
