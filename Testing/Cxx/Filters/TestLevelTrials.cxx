// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which trials are spared, and which results are taken.
 */
#include "Session/LevelTrials.h"
#include "TrialTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace
{

using carving::LevelTarget;
using carving::SimplifiedTarget;

constexpr double Diagonal = 1.0;

using Counts = std::vector<double>;

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

/** The number of levels, negative, and the sum of the logarithms of their distances. */
using Worth = std::pair<int, double>;

/** The least worth of any choice of trials for the targets from `first` on, by trying all. */
Worth FindLeastWorth(const std::vector<LevelTrial>& trials,
  const std::vector<SimplifiedTarget>& targets, std::size_t first, int step)
{
  if (first == targets.size())
  {
    return { 0, 0.0 };
  }
  Worth least = FindLeastWorth(trials, targets, first + 1, step);
  for (const BestTrial& next : RankTrials(trials, targets[first]))
  {
    if (next.Trial->Step >= step)
    {
      const auto [levels, sum] = FindLeastWorth(trials, targets, first + 1, next.Trial->Step);
      least = std::min(least, { levels - 1, sum + std::log(next.Surface->Error) });
    }
  }
  return least;
}

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

// The choice is as good as the best of all choices: as many levels as possible from steps in order,
// and then the least product of distances.
TEST(LevelTrials, AreChosenAsIfAllChoicesWereTried)
{
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> anyStep(0, 5);
  std::uniform_real_distribution<double> anyError(0.01, 0.1);
  const std::vector<double> numbers = { 100.0, 200.0, 400.0, 800.0 };
  const std::vector<SimplifiedTarget> targets = MakeTargets(numbers);
  for (int i = 0; i < 300; ++i)
  {
    std::vector<LevelTrial> trials;
    for (int k = 0; k < 6; ++k)
    {
      trials.push_back(MakeTrial(20 * anyStep(random), { { numbers[k % 4], anyError(random) } }));
    }
    Worth chosen = { 0, 0.0 };
    int step = 0;
    for (const BestTrial& choice : ChooseTrials(trials, targets))
    {
      if (choice.Trial)
      {
        EXPECT_GE(choice.Trial->Step, step);
        step = choice.Trial->Step;
        chosen = { chosen.first - 1, chosen.second + std::log(choice.Surface->Error) };
      }
    }
    const Worth least = FindLeastWorth(trials, targets, 0, 0);
    EXPECT_EQ(chosen.first, least.first) << i;
    EXPECT_GE(chosen.second, least.second - 1e-9) << i;
    // A surface that was made for a smaller number has to be 2 % closer.
    EXPECT_LE(chosen.second, least.second - targets.size() * std::log(0.98) + 1e-9) << i;
  }
}
