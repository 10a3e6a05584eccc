// SPDX-License-Identifier: BSD-3-Clause
#include "Session/LevelTrials.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <deque>
#include <iterator>
#include <map>

namespace
{

using carving::DecimatedSurface;
using carving::LevelTarget;
using carving::SimplifiedTarget;

/**
 * Whether a surface that was made for `value` may be used for a target: it was made for this
 * target, or for a smaller number.
 */
bool MayServe(const DecimatedSurface& surface, double value, const SimplifiedTarget& target)
{
  return value == target.Value || target.Type == LevelTarget::ErrorBound ||
    (value < target.Value && surface.Reached);
}

/**
 * Whether the error tells how good a surface is, rather than the number of vertices: the surface
 * has reached a number, or is too far for an error bound.
 */
bool IsByError(const SimplifiedTarget& target, const DecimatedSurface& surface)
{
  return HasReached(surface, target) == (target.Type != LevelTarget::ErrorBound);
}

/** Errors are accurate to 1 %: closer surfaces differ by more than that. */
constexpr double Clearly = 0.98;

/**
 * The error by which a surface is compared. One that was made for a smaller number than the
 * target's has to be clearly closer, or a run would give the same level twice for next to nothing.
 */
double ComparedError(const SimplifiedTarget& target, const BestTrial& choice)
{
  const auto index = choice.Surface - choice.Trial->Result.Surfaces.data();
  const bool isForLess =
    target.Type != LevelTarget::ErrorBound && choice.Trial->Targets[index].Value < target.Value;
  return choice.Surface->Error / (isForLess ? Clearly : 1.0);
}

bool IsBetter(const SimplifiedTarget& target, const BestTrial& a, const BestTrial& b)
{
  const bool reached = HasReached(*a.Surface, target);
  if (reached != HasReached(*b.Surface, target))
  {
    return reached;
  }
  return IsByError(target, *a.Surface)
    ? ComparedError(target, a) < ComparedError(target, b)
    : CountVertices(*a.Trial, *a.Surface) < CountVertices(*b.Trial, *b.Surface);
}

/**
 * Whether a coarser surface of the same trial is better: clearly closer, where both reach a number.
 */
bool IsCoarserBetter(
  const SimplifiedTarget& target, const BestTrial& coarser, const BestTrial& finer)
{
  return IsBetter(target, coarser, finer) &&
    (target.Type == LevelTarget::ErrorBound || !finer.Surface->Reached ||
      coarser.Surface->Error < Clearly * finer.Surface->Error);
}

/**
 * Whether neither the topology of a step nor its pits keep a surface far from M. The distance of a
 * smooth surface is about inversely proportional to its number of vertices. That of a rough surface
 * falls more slowly: on scans, with the number to the power of 0.6 to 0.8.
 */
bool IsCloseEnough(
  const LevelTrial& trial, const carving::DecimatedSurface& surface, double diagonal)
{
  constexpr double room = 20.0; // vertices per vertex that the topology needs
  constexpr double power = 0.75;
  constexpr double greatest = 1.6; // product, in diagonals: 0.9 % of one at 1,000 vertices
  constexpr double many = 0.25;    // of the vertices: the distance depends on details of M
  const double vertices = CountVertices(trial, surface);
  return surface.Reached && vertices >= room * trial.LeastVertices &&
    (vertices >= many * trial.Result.Chain.Vertices ||
      surface.Error * std::pow(vertices, power) <= greatest * diagonal);
}

/** How bad a surface is for a target, as a logarithm. */
double CostOf(const SimplifiedTarget& target, const BestTrial& choice)
{
  constexpr double notReached = 1e3;
  const DecimatedSurface& surface = *choice.Surface;
  const double cost = IsByError(target, surface)
    ? std::log(std::max(ComparedError(target, choice), DBL_MIN))
    : std::log(static_cast<double>(CountVertices(*choice.Trial, surface)));
  return HasReached(surface, target) ? cost : notReached + cost;
}

} // namespace

void AddTarget(
  std::vector<LevelTrial>& trials, const SimplifiedTarget& target, int step, double bound)
{
  auto trial = std::find_if(trials.begin(), trials.end(),
    [&](const LevelTrial& other)
    { return other.LastStep == target.LastStep && other.Step == step; });
  if (trial == trials.end())
  {
    trials.emplace_back();
    trial = trials.end() - 1;
    trial->LastStep = target.LastStep;
    trial->Step = step;
  }
  std::vector<TrialTarget>& all = trial->Targets;
  const auto found = std::find_if(
    all.begin(), all.end(), [&](const TrialTarget& other) { return other.Value == target.Value; });
  if (found == all.end())
  {
    all.push_back({ target.Value, bound });
    const bool byError = target.Type == LevelTarget::ErrorBound;
    std::sort(all.begin(), all.end(),
      [byError](const TrialTarget& a, const TrialTarget& b)
      { return byError ? a.Value < b.Value : a.Value > b.Value; });
  }
}

double CountVertices(const SimplifiedTarget& target)
{
  return target.Type == LevelTarget::Vertices ? target.Value
    : target.Type == LevelTarget::Triangles   ? target.Value / 2.0
                                              : 1.0;
}

int CountVertices(const LevelTrial& trial, const carving::DecimatedSurface& surface)
{
  return trial.Result.Chain.Vertices - surface.Collapses;
}

bool HasReached(const DecimatedSurface& surface, const SimplifiedTarget& target)
{
  return target.Type == LevelTarget::ErrorBound ? surface.Error <= target.Value
                                                : surface.Reached != 0;
}

bool HasStuck(const LevelTrial& trial, const SimplifiedTarget& target)
{
  const std::vector<DecimatedSurface>& surfaces = trial.Result.Surfaces;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    const auto& [value, bound] = trial.Targets[i];
    if (!surfaces[i].Reached && std::isinf(bound) && value >= target.Value)
    {
      return true;
    }
  }
  return false;
}

std::vector<BestTrial> RankTrials(
  const std::vector<LevelTrial>& trials, const SimplifiedTarget& target)
{
  std::vector<BestTrial> found;
  for (const LevelTrial& trial : trials)
  {
    const std::vector<DecimatedSurface>& surfaces = trial.Result.Surfaces;
    const std::size_t end = trial.Step <= target.LastStep ? surfaces.size() : 0;
    BestTrial best;
    for (std::size_t i = 0; i < end; ++i)
    {
      const BestTrial next = { &trial, &surfaces[i] };
      if (MayServe(surfaces[i], trial.Targets[i].Value, target) &&
        (!best.Trial || IsCoarserBetter(target, next, best)))
      {
        best = next;
      }
    }
    if (best.Trial)
    {
      found.push_back(best);
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [&](const BestTrial& a, const BestTrial& b) { return IsBetter(target, a, b); });
  return found;
}

BestTrial FindBestTrial(const std::vector<LevelTrial>& trials, const SimplifiedTarget& target)
{
  const std::vector<BestTrial> found = RankTrials(trials, target);
  return found.empty() ? BestTrial() : found.front();
}

std::vector<BestTrial> ChooseTrials(
  const std::vector<LevelTrial>& trials, const std::vector<SimplifiedTarget>& targets)
{
  struct Choice
  {
    BestTrial Best;
    std::size_t Target;
    const Choice* Coarser; ///< the one before; null if this is the first
    int Levels;            ///< up to this one
    double Cost;           ///< of all these
  };
  const auto isBetter = [](const Choice& a, const Choice& b)
  { return a.Levels != b.Levels ? a.Levels > b.Levels : a.Cost < b.Cost; };
  std::deque<Choice> choices;            // from coarse to fine
  std::map<int, const Choice*> bestUpTo; // by step, each better than those of smaller steps
  const auto findBestUpTo = [&](int step)
  {
    const auto next = bestUpTo.upper_bound(step);
    return next == bestUpTo.begin() ? nullptr : std::prev(next)->second;
  };
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    const std::size_t before = choices.size();
    for (const BestTrial& next : RankTrials(trials, targets[i]))
    {
      const Choice* coarser = findBestUpTo(next.Trial->Step);
      const double cost = CostOf(targets[i], next);
      choices.push_back(coarser
          ? Choice{ next, i, coarser, coarser->Levels + 1, coarser->Cost + cost }
          : Choice{ next, i, nullptr, 1, cost });
    }
    for (std::size_t k = before; k < choices.size(); ++k)
    {
      const int step = choices[k].Best.Trial->Step;
      const Choice* known = findBestUpTo(step);
      if (!known || isBetter(choices[k], *known))
      {
        bestUpTo[step] = &choices[k];
        auto next = bestUpTo.upper_bound(step);
        while (next != bestUpTo.end() && !isBetter(*next->second, choices[k]))
        {
          next = bestUpTo.erase(next);
        }
      }
    }
  }
  std::vector<BestTrial> chosen(targets.size());
  for (const Choice* choice = bestUpTo.empty() ? nullptr : bestUpTo.rbegin()->second; choice;
       choice = choice->Coarser)
  {
    chosen[choice->Target] = choice->Best;
  }
  return chosen;
}

void DropTargetsOfLastStep(
  const std::vector<LevelTrial>& trials, double diagonal, double own, LevelTrial& trial)
{
  double least = HUGE_VAL;
  for (const LevelTrial& last : trials)
  {
    for (std::size_t i = 0; i < last.Result.Surfaces.size(); ++i)
    {
      if (last.Step == trial.LastStep && IsCloseEnough(last, last.Result.Surfaces[i], diagonal))
      {
        least = std::min(least, last.Targets[i].Value);
      }
    }
  }
  DropTargetsIf(
    trial, [&](const TrialTarget& target) { return target.Value >= least && target.Value < own; });
}
