// SPDX-License-Identifier: BSD-3-Clause
#include "Session/TighterTrials.h"

#include "Session/TrialPlans.h"

#include <algorithm>
#include <cmath>

namespace
{

using carving::DecimationOptions;
using carving::LevelTarget;
using carving::SimplifiedTarget;

bool IsBound(const LevelTrial& trial)
{
  return !trial.Targets.empty() && !std::isinf(trial.Targets.front().Bound);
}

bool IsBoundFor(const LevelTrial& trial, const SimplifiedTarget& target)
{
  return IsBound(trial) && trial.LastStep == target.LastStep &&
    std::any_of(trial.Targets.begin(), trial.Targets.end(),
      [&](const TrialTarget& other) { return other.Value == target.Value; });
}

} // namespace

double FindTighterBound(int vertices, double error)
{
  // For less gain, the mean distance grows too much.
  return vertices <= DecimationOptions::FewVertices ? 0.94 * error
    : vertices <= DecimationOptions::ManyVertices   ? 0.875 * error
                                                    : HUGE_VAL;
}

std::vector<LevelTrial> PlanTighterTrials(const carving::Profile& profile,
  const std::vector<SimplifiedTarget>& targets, const std::vector<LevelTrial>& trials)
{
  constexpr double similar = 0.85;
  constexpr std::size_t most = 5; // per target
  std::vector<LevelTrial> added;
  for (const SimplifiedTarget& target : targets)
  {
    std::vector<BestTrial> closest = RankTrials(trials, target);
    const bool isFirst = std::none_of(trials.begin(), trials.end(),
      [&](const LevelTrial& trial) { return IsBoundFor(trial, target); });
    const bool goesOn = !closest.empty() && closest.front().Surface->Reached &&
      (isFirst || IsBound(*closest.front().Trial));
    if (target.Type == LevelTarget::ErrorBound || !goesOn)
    {
      continue;
    }
    closest.erase(std::remove_if(closest.begin(), closest.end(),
                    [](const BestTrial& found) { return IsBound(*found.Trial); }),
      closest.end());
    const double error = closest.front().Surface->Error;
    const std::size_t begin = isFirst ? 0 : 1, end = isFirst ? 1 : std::min(most, closest.size());
    for (std::size_t i = begin; i < end; ++i)
    {
      const auto& [trial, surface] = closest[i];
      const int vertices = profile.Vertices[trial->Step];
      const double bound = FindTighterBound(vertices, error);
      const bool isAffordable = isFirst || vertices <= DecimationOptions::FewVertices;
      if (isAffordable && std::isfinite(bound) && surface->Reached &&
        similar * surface->Error <= error)
      {
        AddTarget(added, target, trial->Step, bound);
      }
    }
  }
  return added;
}

std::vector<LevelTrial> PlanTighterTrialsBetween(const carving::Profile& profile,
  const std::vector<SimplifiedTarget>& targets, const std::vector<LevelTrial>& trials)
{
  constexpr double closer = 0.97;
  std::vector<LevelTrial> added;
  for (const SimplifiedTarget& target : targets)
  {
    const BestTrial best = FindBestTrial(trials, target);
    if (!best.Trial || !best.Surface->Reached || !IsBound(*best.Trial))
    {
      continue;
    }
    for (const auto& [step, finer] : FindStepsBetween(profile, trials, *best.Trial, target))
    {
      if (profile.Vertices[step] <= DecimationOptions::FewVertices)
      {
        AddTarget(added, target, step, closer * best.Surface->Error);
      }
    }
  }
  return added;
}
