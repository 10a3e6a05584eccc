// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Measure/SimplifiedStream.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace carving
{
namespace
{

int CountAfter(const CollapseChain& chain, LevelTarget type, int collapses)
{
  return type == LevelTarget::Triangles ? chain.Triangles - 2 * collapses
                                        : chain.Vertices - collapses;
}

/** The number of collapses after which the count is at most the target. */
int CollapsesFor(const CollapseChain& chain, LevelTarget type, double target)
{
  const int removed = type == LevelTarget::Triangles ? 2 : 1;
  const double excess = CountAfter(chain, type, 0) - target;
  // fmax ignores a target that is not a number.
  return static_cast<int>(std::fmin(std::fmax(0.0, std::ceil(excess / removed)), 1e9));
}

/** The levels made for the target's last step; if there are none, all from that step or before. */
std::vector<SimplifiedLevel> FindCandidates(
  const SimplifiedStream& stream, const SimplifiedTarget& target)
{
  std::vector<SimplifiedLevel> same, earlier;
  for (const SimplifiedLevel& level : stream.Levels)
  {
    if (level.LastStep == target.LastStep)
    {
      same.push_back(level);
    }
    if (stream.Steps[level.Chain].Step <= target.LastStep)
    {
      earlier.push_back(level);
    }
  }
  return same.empty() ? earlier : same;
}

/** What the level was made for, or what came of it, as a target of another type. */
double TargetOf(const SimplifiedStream& stream, const SimplifiedLevel& level, LevelTarget type)
{
  return type == stream.Type ? level.Target
    : type == LevelTarget::ErrorBound
    ? level.Error
    : CountAfter(stream.Steps[level.Chain].Chain, type, level.Collapses);
}

/** Whether a level has no more vertices or triangles than the number. */
bool IsMet(
  const SimplifiedStream& stream, const SimplifiedLevel& level, const SimplifiedTarget& number)
{
  const CollapseChain& chain = stream.Steps[level.Chain].Chain;
  return CountAfter(chain, number.Type, level.Collapses) <= number.Value;
}

/**
 * Where the step of the given level has fewer vertices or triangles than the number, finds a later
 * step: the first that has as many. If that step cannot be decimated to the number, the last step
 * before it that can is taken.
 */
SimplifiedLevel UseNumber(
  const SimplifiedStream& stream, const SimplifiedLevel& given, const SimplifiedTarget& target)
{
  std::vector<int> later;
  const int first = stream.Steps[given.Chain].Step;
  for (int i = 0; i < static_cast<int>(stream.Steps.size()); ++i)
  {
    if (stream.Steps[i].Step > first && stream.Steps[i].Step <= target.LastStep)
    {
      later.push_back(i);
    }
  }
  std::sort(later.begin(), later.end(),
    [&](int a, int b) { return stream.Steps[a].Step < stream.Steps[b].Step; });
  SimplifiedLevel best = given;
  double count = CountAfter(stream.Steps[given.Chain].Chain, target.Type, 0);
  for (auto i = later.begin(); i != later.end() && count < target.Value; ++i)
  {
    const CollapseChain& chain = stream.Steps[*i].Chain;
    const int collapses = CollapsesFor(chain, target.Type, target.Value);
    count = CountAfter(chain, target.Type, 0);
    if (collapses <= chain.Collapses)
    {
      best = { *i, collapses };
    }
  }
  return best;
}

/**
 * The level from the candidates, coarse to fine, for a number of vertices or triangles: if none
 * gets there, the one that comes closest.
 */
SimplifiedLevel SelectByNumber(const SimplifiedStream& stream,
  const std::vector<SimplifiedLevel>& candidates, const SimplifiedTarget& target)
{
  auto next = std::find_if(candidates.begin(), candidates.end(),
    [&](const SimplifiedLevel& level)
    { return TargetOf(stream, level, target.Type) >= target.Value; });
  const bool beyondTargets = next == candidates.end();
  next = beyondTargets ? next - 1 : next;
  const auto leastOf = [&](const SimplifiedLevel& level)
  {
    const CollapseChain& chain = stream.Steps[level.Chain].Chain;
    return CountAfter(chain, target.Type, chain.Collapses);
  };
  auto closest = next;
  for (auto level = next + 1; level-- != candidates.begin();)
  {
    const CollapseChain& chain = stream.Steps[level->Chain].Chain;
    const int collapses = CollapsesFor(chain, target.Type, target.Value);
    closest = leastOf(*level) < leastOf(*closest) ? level : closest;
    if (collapses <= chain.Collapses)
    {
      const SimplifiedLevel selected = { level->Chain, collapses };
      return beyondTargets ? UseNumber(stream, selected, target) : selected;
    }
  }
  const int all = stream.Steps[closest->Chain].Chain.Collapses;
  return closest->Collapses == all ? *closest : SimplifiedLevel{ closest->Chain, all };
}

std::string DescribeMiss(
  const SimplifiedStream& stream, const SimplifiedLevel& level, const SimplifiedTarget& target)
{
  const CollapseChain& chain = stream.Steps[level.Chain].Chain;
  std::ostringstream problem;
  if (target.Type == LevelTarget::ErrorBound && !(level.Error <= target.Value))
  {
    problem << "No stored simplified level is within " << target.Value
            << " of the mesh: the closest one is within " << level.Error << ".";
  }
  else if (target.Type != LevelTarget::ErrorBound && !IsMet(stream, level, target))
  {
    problem << "The target of " << target.Value
            << " is out of reach: the coarsest stored simplified level has "
            << CountAfter(chain, LevelTarget::Vertices, level.Collapses) << " vertices and "
            << CountAfter(chain, LevelTarget::Triangles, level.Collapses) << " triangles.";
  }
  return problem.str();
}

} // namespace

SimplifiedTarget MakeSimplifiedTarget(
  const Profile& profile, LevelTarget type, double target, int maximumVertices)
{
  if (type == LevelTarget::Vertices || type == LevelTarget::Triangles ||
    type == LevelTarget::ErrorBound)
  {
    return { type, profile.LastStep(), target, {} };
  }
  const SelectedStep selected = SelectStep(profile, type, target);
  return { LevelTarget::Vertices, selected.Step, maximumVertices > 0 ? maximumVertices : HUGE_VAL,
    selected.Problem };
}

bool IsMetByCarving(const Profile& profile, const SimplifiedTarget& target)
{
  return target.Type != LevelTarget::ErrorBound &&
    target.Value >=
    (target.Type == LevelTarget::Triangles ? profile.Triangles : profile.Vertices)[target.LastStep];
}

double FindLeastTarget(const SimplifiedStream& stream, LevelTarget type)
{
  double least = HUGE_VAL;
  if (type == LevelTarget::Vertices || type == LevelTarget::Triangles)
  {
    for (const DecimatedStep& step : stream.Steps)
    {
      least = std::min<double>(least, CountAfter(step.Chain, type, step.Chain.Collapses));
    }
  }
  if (type == LevelTarget::ErrorBound)
  {
    for (const SimplifiedLevel& level : stream.Levels)
    {
      least = std::fmin(least, level.Error); // ignores NaN
    }
  }
  return least;
}

SelectedLevel SelectSimplifiedLevel(const SimplifiedStream& stream, const SimplifiedTarget& target)
{
  const std::vector<SimplifiedLevel> candidates = FindCandidates(stream, target);
  if (candidates.empty())
  {
    return { {},
      "The stream has no simplified level for this target. Carve with LevelSimplification and the "
      "target." };
  }
  SelectedLevel selected;
  // For a number that is out of reach, the level of another target may come closer.
  const auto made = std::find_if(candidates.begin(), candidates.end(),
    [&](const SimplifiedLevel& level)
    {
      return TargetOf(stream, level, target.Type) == target.Value &&
        (target.Type == LevelTarget::ErrorBound || IsMet(stream, level, target));
    });
  if (made != candidates.end())
  {
    selected.Level = *made;
  }
  else if (target.Type == LevelTarget::ErrorBound)
  {
    const auto within = std::find_if(candidates.begin(), candidates.end(),
      [&](const SimplifiedLevel& level)
      { return TargetOf(stream, level, target.Type) <= target.Value; });
    // Finer levels are not always closer. Levels whose error is not known come last.
    const auto errorOf = [](const SimplifiedLevel& level)
    { return std::isnan(level.Error) ? HUGE_VAL : level.Error; };
    const auto closest = std::min_element(candidates.begin(), candidates.end(),
      [&](const SimplifiedLevel& a, const SimplifiedLevel& b) { return errorOf(a) < errorOf(b); });
    selected.Level = within != candidates.end() ? *within : *closest;
  }
  else
  {
    selected.Level = SelectByNumber(stream, candidates, target);
  }
  selected.Problem = DescribeMiss(stream, selected.Level, target);
  return selected;
}

int FindCarvedStepWithin(
  const SimplifiedStream& stream, const Profile& profile, const SimplifiedTarget& target)
{
  if (target.Type != LevelTarget::ErrorBound || stream.Levels.empty())
  {
    return -1;
  }
  int first = 0;
  for (const SimplifiedLevel& level : stream.Levels)
  {
    first = std::max(first, stream.Steps[level.Chain].Step);
  }
  for (int step = first; step < static_cast<int>(profile.Error.size()); ++step)
  {
    if (profile.Error[step] <= target.Value)
    {
      return step;
    }
  }
  return -1;
}

} // namespace carving
