// SPDX-License-Identifier: BSD-3-Clause
#include "Session/TrialPlans.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using carving::DecimationOptions;
using carving::LevelTarget;
using carving::Profile;
using carving::SimplifiedTarget;

bool HaveSameTopology(const Profile& profile, int a, int b)
{
  return profile.Components[a] == profile.Components[b] &&
    profile.Tunnels[a] == profile.Tunnels[b] && profile.Voids[a] == profile.Voids[b];
}

/**
 * Whether a step has been found to keep more vertices than a target asks for, as where parts touch
 * or sheets end. Coarser steps of the same topology may keep fewer.
 */
bool KeepsTooMany(const std::vector<LevelTrial>& trials, int step, const SimplifiedTarget& target)
{
  return target.Type != LevelTarget::ErrorBound &&
    std::any_of(trials.begin(), trials.end(),
      [&](const LevelTrial& trial)
      {
        return trial.Step == step &&
          (trial.VerticesThatTouch > CountVertices(target) || HasStuck(trial, target));
      });
}

/** The last step up to `last` with at most this many vertices; -1 if C0 has more. */
int FindStep(const Profile& profile, int last, double vertices)
{
  const auto begin = profile.Vertices.begin();
  return static_cast<int>(std::upper_bound(begin, begin + last + 1, vertices) - begin) - 1;
}

/** The last step up to `last` with at most this many components and tunnels; 0 if there is none. */
int FindSimpleStep(const Profile& profile, int last, double parts)
{
  int step = last;
  while (step > 0 && profile.Components[step] + profile.Tunnels[step] > parts)
  {
    --step;
  }
  return step;
}

using TargetIterator = std::vector<SimplifiedTarget>::const_iterator;

/** Adds the targets of a range that have this last step to the trial of `step`. */
void AddTargets(
  std::vector<LevelTrial>& trials, int lastStep, int step, TargetIterator begin, TargetIterator end)
{
  for (auto target = begin; target != end; ++target)
  {
    if (target->LastStep == lastStep)
    {
      AddTarget(trials, *target, step);
    }
  }
}

/**
 * The end of the range of targets for which a trial of one target is run: all finer numbers, but
 * no finer bound.
 */
TargetIterator FindEnd(const std::vector<SimplifiedTarget>& targets, TargetIterator target)
{
  return target->Type == LevelTarget::ErrorBound ? target + 1 : targets.end();
}

/** The coarsest steps that are worth a trial for a target, from fine to coarse. */
std::vector<int> FindCoarsestSteps(const Profile& profile, const SimplifiedTarget& target)
{
  if (target.Type != LevelTarget::ErrorBound)
  {
    return { 0 };
  }
  // Vertices that slide inward bring some steps to within the bound that are a little farther.
  constexpr double farther = 1.25;
  const auto findStep = [&](double bound)
  { return carving::SelectStep(profile, target.Type, bound).Step; };
  // Where hollows open, later steps may be farther than earlier ones, whose walls are all on M.
  const auto first = std::find_if(profile.Error.begin(), profile.Error.end(),
    [&](double error) { return error <= target.Value; });
  std::vector<int> steps = { findStep(target.Value), findStep(farther * target.Value) };
  if (first != profile.Error.end())
  {
    steps.push_back(static_cast<int>(first - profile.Error.begin()));
  }
  return steps;
}

/** The steps before the last one that are decimated for a target at first, from fine to coarse. */
std::vector<int> SelectSteps(
  const Profile& profile, const SimplifiedTarget& target, const std::vector<LevelTrial>& trials)
{
  const int last = target.LastStep;
  const std::vector<int> coarsest = FindCoarsestSteps(profile, target);
  std::vector<int> steps = { last };
  const double least = CountVertices(target);
  for (double count = profile.Vertices[last] / 2.0; count >= least; count /= 2.0)
  {
    const int step = FindStep(profile, last, count);
    if (step < coarsest.front())
    {
      break;
    }
    if (!HaveSameTopology(profile, step, steps.back()) ||
      KeepsTooMany(trials, steps.back(), target))
    {
      steps.push_back(step);
    }
  }
  if (steps.size() == 1) // all vertices are on the hull, so that their number tells nothing
  {
    constexpr double verticesOfPart = 4.0; // a component or tunnel keeps about as many
    for (double parts = least / verticesOfPart; parts >= 1.0; parts /= 2.0)
    {
      const int step = FindSimpleStep(profile, last, parts);
      if (!HaveSameTopology(profile, step, steps.back()))
      {
        steps.push_back(step);
      }
    }
  }
  for (const int step : coarsest)
  {
    // A hull's collapses do not stick. Where parts touch, equal numbers hide different surfaces.
    const bool inAnyCase = step == 0 || profile.Vertices[step] <= DecimationOptions::FewVertices;
    if (steps.back() > step && (inAnyCase || !HaveSameTopology(profile, step, steps.back())))
    {
      steps.push_back(step);
    }
  }
  steps.erase(steps.begin());
  return steps;
}

bool IsPlannedFor(const LevelTrial& trial, double value)
{
  const auto isFor = [value](const TrialTarget& target) { return target.Value == value; };
  return std::any_of(trial.Targets.begin(), trial.Targets.end(), isFor) ||
    std::any_of(trial.Dropped.begin(), trial.Dropped.end(), isFor);
}

} // namespace

NeighborSteps FindNeighborSteps(
  const std::vector<LevelTrial>& trials, int of, const SimplifiedTarget& target)
{
  NeighborSteps steps = { of, of };
  for (const LevelTrial& trial : trials)
  {
    const int step = IsPlannedFor(trial, target.Value) ? trial.Step : of;
    if (step < of && (steps.Coarser == of || step > steps.Coarser))
    {
      steps.Coarser = step;
    }
    if (step > of && step <= target.LastStep && (steps.Finer == of || step < steps.Finer))
    {
      steps.Finer = step;
    }
  }
  return steps;
}

std::optional<int> FindStepBetween(const Profile& profile, int coarser, int finer)
{
  const double low = profile.Vertices[coarser], high = profile.Vertices[finer];
  const int step =
    low == high ? (coarser + finer) / 2 : FindStep(profile, finer, std::sqrt(low * high));
  return step > coarser && step < finer ? std::make_optional(step) : std::nullopt;
}

bool TriesCoarseStepsFirst(const std::vector<SimplifiedTarget>& targets)
{
  return targets.size() == 1 && targets.front().Type == LevelTarget::ErrorBound;
}

std::vector<LevelTrial> PlanTrialsOfLastSteps(const std::vector<SimplifiedTarget>& targets)
{
  std::vector<LevelTrial> trials;
  for (const SimplifiedTarget& target : targets)
  {
    AddTarget(trials, target, target.LastStep);
  }
  return trials;
}

std::vector<LevelTrial> PlanTrials(const Profile& profile,
  const std::vector<SimplifiedTarget>& targets, const std::vector<LevelTrial>& known)
{
  std::vector<LevelTrial> trials;
  for (auto target = targets.begin(); target != targets.end(); ++target)
  {
    // A step that is good for a coarse level may be better for a finer one than any other, too.
    const auto end = FindEnd(targets, target);
    for (const int step : SelectSteps(profile, *target, known))
    {
      AddTargets(trials, target->LastStep, step, target, end);
    }
    if (target->Type != LevelTarget::ErrorBound)
    {
      const carving::SelectedStep carved =
        carving::SelectStep(profile, target->Type, target->Value);
      if (carved.Problem.empty() && carved.Step < target->LastStep)
      {
        AddTargets(trials, target->LastStep, carved.Step, target, end);
      }
    }
  }
  // The first trials tell which others are worth their time.
  std::stable_sort(trials.begin(), trials.end(),
    [coarseFirst = TriesCoarseStepsFirst(targets)](const LevelTrial& a, const LevelTrial& b)
    { return coarseFirst ? a.Step < b.Step : a.Step > b.Step; });
  return trials;
}

std::vector<LevelTrial> PlanTrialsBetween(const Profile& profile,
  const std::vector<SimplifiedTarget>& targets, const std::vector<LevelTrial>& trials,
  int mostVertices)
{
  std::vector<LevelTrial> added;
  for (auto target = targets.begin(); target != targets.end(); ++target)
  {
    const BestTrial best = FindBestTrial(trials, *target);
    if (!best.Trial)
    {
      continue;
    }
    const int own = best.Trial->Step;
    const NeighborSteps tried = FindNeighborSteps(trials, own, *target);
    for (const auto& [coarser, finer] :
      { std::array{ tried.Coarser, own }, std::array{ own, tried.Finer } })
    {
      const std::optional<int> step = FindStepBetween(profile, coarser, finer);
      if (step && profile.Vertices[*step] <= mostVertices &&
        (!HaveSameTopology(profile, *step, finer) || KeepsTooMany(trials, finer, *target)))
      {
        // A coarser level may not come from a later step, so the coarser targets are tried as well.
        AddTargets(added, target->LastStep, *step, targets.begin(), FindEnd(targets, target));
      }
    }
  }
  return added;
}
