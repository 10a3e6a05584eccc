// SPDX-License-Identifier: BSD-3-Clause
#include "Session/LevelTrials.h"

#include <algorithm>

namespace
{

using carving::DecimatedSurface;
using carving::LevelTarget;
using carving::SimplifiedTarget;

int CountVertices(const LevelTrial& trial, const DecimatedSurface& surface)
{
  return trial.Result.Chain.Vertices - surface.Collapses;
}

/** Whether a surface for `value` may be taken for a target: for this value, or a smaller number. */
bool MayServe(const DecimatedSurface& surface, double value, const SimplifiedTarget& target)
{
  return value == target.Value ||
    (target.Type != LevelTarget::ErrorBound && value < target.Value && surface.Reached);
}

bool IsBetter(LevelTarget type, const BestTrial& a, const BestTrial& b)
{
  if (a.Surface->Reached != b.Surface->Reached)
  {
    return a.Surface->Reached > b.Surface->Reached;
  }
  return a.Surface->Reached && type != LevelTarget::ErrorBound
    ? a.Surface->Error < b.Surface->Error
    : CountVertices(*a.Trial, *a.Surface) < CountVertices(*b.Trial, *b.Surface);
}

/**
 * Whether neither the topology of the last step nor its pits keep a level with `value` vertices or
 * triangles far from M.
 */
bool IsLastStepGoodEnough(
  const std::vector<LevelTrial>& trials, int lastStep, double value, double diagonal)
{
  constexpr double room = 20.0; // vertices per vertex that the topology needs
  // The distance of a smooth surface is about inversely proportional to its number of vertices.
  // Their product is 3 to 6 diagonals on scans and mechanical parts, and grows where pits need the
  // vertices.
  constexpr double smooth = 6.0;
  constexpr double mostGrowth = 1.25;
  constexpr double many = 0.25; // of the vertices: the distance depends on details of M
  for (const LevelTrial& trial : trials)
  {
    double finer = smooth * diagonal; // the product for the next finer target
    for (std::size_t i = 0; trial.Step == lastStep && i < trial.Result.Surfaces.size(); ++i)
    {
      const DecimatedSurface& surface = trial.Result.Surfaces[i];
      const double vertices = CountVertices(trial, surface);
      const double product = surface.Error * vertices;
      if (trial.Targets[i].Value == value)
      {
        return surface.Reached && vertices >= room * trial.LeastVertices &&
          (vertices >= many * trial.Result.Chain.Vertices ||
            product <= (i > 0 ? mostGrowth : 1.0) * finer);
      }
      finer = product;
    }
  }
  return false;
}

} // namespace

std::vector<BestTrial> RankTrials(
  const std::vector<LevelTrial>& trials, const SimplifiedTarget& target, int lastStep)
{
  std::vector<BestTrial> found;
  for (const LevelTrial& trial : trials)
  {
    const std::vector<DecimatedSurface>& surfaces = trial.Result.Surfaces;
    const std::size_t end = trial.Step <= std::min(lastStep, target.LastStep) ? surfaces.size() : 0;
    BestTrial best;
    for (std::size_t i = 0; i < end; ++i)
    {
      const BestTrial next = { &trial, &surfaces[i] };
      if (MayServe(surfaces[i], trial.Targets[i].Value, target) &&
        (!best.Trial || IsBetter(target.Type, next, best)))
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
    [&](const BestTrial& a, const BestTrial& b) { return IsBetter(target.Type, a, b); });
  return found;
}

BestTrial FindBestTrial(
  const std::vector<LevelTrial>& trials, const SimplifiedTarget& target, int lastStep)
{
  const std::vector<BestTrial> found = RankTrials(trials, target, lastStep);
  return found.empty() ? BestTrial() : found.front();
}

void DropTargetsOfLastStep(
  const std::vector<LevelTrial>& trials, double diagonal, LevelTrial& trial)
{
  bool drop = true;
  DropTargetsIf(trial,
    [&](double value)
    {
      drop = drop && IsLastStepGoodEnough(trials, trial.LastStep, value, diagonal);
      return drop;
    });
}
