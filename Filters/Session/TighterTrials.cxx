// SPDX-License-Identifier: BSD-3-Clause
#include "Session/TighterTrials.h"

#include "Session/TrialPlans.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{

using carving::DecimationOptions;
using carving::LevelTarget;
using carving::SimplifiedTarget;

bool AnyTarget(const std::vector<TrialTarget>& targets, double value,
  const std::function<bool(double bound)>& predicate)
{
  return std::any_of(targets.begin(), targets.end(),
    [&](const TrialTarget& target) { return target.Value == value && predicate(target.Bound); });
}

/**
 * Whether there is nothing to gain from a step any more: it has been tried within a bound, is
 * farther from M than a bound, or has stuck above the number.
 */
bool IsDone(const std::vector<LevelTrial>& trials, int step, const SimplifiedTarget& target)
{
  const auto isBound = [](double bound) { return std::isfinite(bound); };
  return std::any_of(trials.begin(), trials.end(),
    [&](const LevelTrial& trial)
    {
      return trial.LastStep == target.LastStep && trial.Step == step &&
        (AnyTarget(trial.Targets, target.Value, isBound) ||
          AnyTarget(trial.Dropped, target.Value, isBound) || HasStuck(trial, target));
    });
}

/** What is sought for a target. */
struct Search
{
  const SimplifiedTarget* Target;
  int Step; ///< of the best trial
  double Error;
  double Bound; ///< for other steps
};

bool MayTry(const carving::Profile& profile, const std::vector<LevelTrial>& trials,
  const Search& search, int step)
{
  constexpr double most = 32.0; // per vertex that is left; larger steps seldom win
  const int vertices = profile.Vertices[step];
  return vertices <= DecimationOptions::ManyVertices &&
    (step == search.Step || vertices <= most * CountVertices(*search.Target)) &&
    !IsDone(trials, step, *search.Target);
}

/** None where nothing more is to be sought: the last trials have gained nothing. */
std::optional<Search> StartSearch(const carving::Profile& profile,
  const std::vector<LevelTrial>& trials, const SimplifiedTarget& target)
{
  const BestTrial best = FindBestTrial(trials, target);
  if (target.Type == LevelTarget::ErrorBound || !best.Trial || !best.Surface->Reached)
  {
    return std::nullopt;
  }
  // Trials of large steps take longer, and have to gain more.
  const int step = best.Trial->Step;
  const bool few = profile.Vertices[step] <= DecimationOptions::FewVertices;
  const double closer = few ? 0.97 : 0.94;
  const int enough = few ? 3 : 2;
  const double error = best.Surface->Error, bound = closer * error;
  const auto inVain = std::count_if(trials.begin(), trials.end(),
    [&](const LevelTrial& trial)
    {
      return trial.LastStep == target.LastStep &&
        AnyTarget(trial.Targets, target.Value, [bound](double other) { return other == bound; });
    });
  return inVain < enough ? std::make_optional(Search{ &target, step, error, bound }) : std::nullopt;
}

/** The steps that are tried next. */
std::vector<int> FindNextSteps(
  const carving::Profile& profile, const std::vector<LevelTrial>& trials, const Search& search)
{
  std::vector<int> steps = { search.Step };
  const NeighborSteps tried = FindNeighborSteps(trials, search.Step, *search.Target);
  for (const int neighbor : { tried.Coarser, tried.Finer })
  {
    const auto [coarser, finer] = std::minmax(search.Step, neighbor);
    steps.push_back(MayTry(profile, trials, search, neighbor)
        ? neighbor
        : FindStepBetween(profile, coarser, finer).value_or(search.Step));
  }
  return steps;
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
  std::vector<LevelTrial> added;
  std::vector<Search> searches; // for this target and coarser ones
  for (const SimplifiedTarget& target : targets)
  {
    const std::optional<Search> started = StartSearch(profile, trials, target);
    if (!started)
    {
      continue;
    }
    searches.push_back(*started);
    for (const int step : FindNextSteps(profile, trials, *started))
    {
      // Most of the time goes into the first collapses, so that coarser targets cost little.
      for (const Search& search : searches)
      {
        const bool isOwn = step == search.Step;
        if ((search.Target == &target || !isOwn) && search.Target->LastStep == target.LastStep &&
          MayTry(profile, trials, search, step))
        {
          AddTarget(added, *search.Target, step,
            isOwn ? FindTighterBound(profile.Vertices[step], search.Error) : search.Bound);
        }
      }
    }
  }
  return added;
}
