// SPDX-License-Identifier: BSD-3-Clause
#include "Session/SimplifyLevels.h"

#include "Session/TighterTrials.h"
#include "Session/TrialPlans.h"
#include "Session/TrialRunner.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace
{

using carving::DecimationOptions;
using carving::LevelTarget;
using carving::SimplifiedTarget;

/** Adds the decimated step of a trial, with its new points. Returns its index. */
int AddStep(const LevelTrial& trial, CarvedLeaf<3>& carved)
{
  std::vector<carving::DecimatedStep>& steps = carved.Simplified.Steps;
  carving::DecimatedStep& step = steps.emplace_back();
  step.Step = trial.Step;
  step.SurfaceComponents = trial.SurfaceComponents;
  step.SurfaceGenus = trial.SurfaceGenus;
  step.Chain = trial.Result.Chain;
  for (carving::ChainFace& face : step.Chain.Faces)
  {
    face.Source = trial.Cells[face.Source];
  }
  carving::ResolvedMesh& surface = carved.Stream.Mesh.Surface;
  for (std::size_t i = 0; i < trial.Result.Points.size(); ++i)
  {
    const int source = trial.Result.PointSources[i];
    if (source >= 0)
    {
      step.Points.push_back(trial.Points[source]);
      continue;
    }
    step.Points.push_back(static_cast<int>(surface.Points.size()));
    surface.Points.push_back(trial.Result.Points[i]);
    surface.PointSources.push_back(-1);
  }
  return static_cast<int>(steps.size()) - 1;
}

/** Adds the levels of the best trials. */
void AddBestLevels(const std::vector<LevelTrial>& trials,
  const std::vector<SimplifiedTarget>& targets, CarvedLeaf<3>& carved)
{
  carving::SimplifiedStream& simplified = carved.Simplified;
  simplified.Type = targets.front().Type;
  std::map<const LevelTrial*, int> added;
  const std::vector<BestTrial> chosen = ChooseTrials(trials, targets);
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    const auto& [trial, surface] = chosen[i];
    if (trial)
    {
      const auto found = added.find(trial);
      const int index = found != added.end() ? found->second : AddStep(*trial, carved);
      added[trial] = index;
      simplified.Levels.push_back(
        { index, surface->Collapses, surface->Error, targets[i].LastStep, targets[i].Value });
    }
  }
  // The stream keeps the last step, too, for numbers above all targets.
  const auto last = std::find_if(trials.begin(), trials.end(),
    [&](const LevelTrial& trial)
    { return trial.Step == targets.back().LastStep && !trial.Result.Surfaces.empty(); });
  if (last != trials.end() && added.find(&*last) == added.end())
  {
    AddStep(*last, carved);
  }
}

/** Names the first step that could not be decimated, and the number of others. */
void AddProblems(const std::vector<LevelTrial>& trials, std::vector<std::string>& problems)
{
  const auto hasFailed = [](const LevelTrial& trial) { return !trial.Error.empty(); };
  const auto first = std::find_if(trials.begin(), trials.end(), hasFailed);
  if (first != trials.end())
  {
    const auto others = std::count_if(first + 1, trials.end(), hasFailed);
    problems.push_back("Step " + std::to_string(first->Step) +
      " of the stream cannot be simplified. " + first->Error +
      (others > 0 ? " Nor can " + std::to_string(others) + (others == 1 ? " other." : " others.")
                  : ""));
  }
}

} // namespace

std::vector<SimplifiedTarget> MakeSimplifiedTargets(
  const carving::Profile& profile, const CarverSettings& settings)
{
  std::vector<SimplifiedTarget> targets;
  for (const double target : settings.LevelTargets)
  {
    targets.push_back(carving::MakeSimplifiedTarget(
      profile, settings.TargetType, target, settings.MaximumVertices));
  }
  if (targets.empty())
  {
    for (const int step : carving::SpreadLevels(profile, settings.NumberOfLevels))
    {
      targets.push_back(
        carving::MakeSimplifiedTarget(profile, LevelTarget::Vertices, profile.Vertices[step], 0));
    }
  }
  std::sort(targets.begin(), targets.end(),
    [](const SimplifiedTarget& a, const SimplifiedTarget& b)
    {
      return a.LastStep != b.LastStep       ? a.LastStep < b.LastStep
        : a.Type == LevelTarget::ErrorBound ? a.Value > b.Value
                                            : a.Value < b.Value;
    });
  return targets;
}

bool SimplifyLevels(const DecomposedLeaf<3>& leaf, const CarverSettings& settings,
  CarverStages& stages, CarvedLeaf<3>& carved, std::vector<std::string>& problems)
{
  const CarverStages::Timer timer(stages, SimplifyStage);
  const carving::Profile& profile = carved.Profile;
  std::vector<SimplifiedTarget> targets = MakeSimplifiedTargets(profile, settings);
  targets.erase(
    std::remove_if(targets.begin(), targets.end(),
      [&](const SimplifiedTarget& target) { return carving::IsMetByCarving(profile, target); }),
    targets.end());
  if (targets.empty())
  {
    return true;
  }
  TrialRunner runner(leaf, carved, settings.ThreadsOfLeaf, stages);
  const std::vector<LevelTrial>& trials = runner.GetTrials();
  const auto between = [&](int mostVertices)
  { return PlanTrialsBetween(profile, targets, trials, mostVertices); };
  std::vector<std::function<std::vector<LevelTrial>()>> rounds = {
    [&] { return PlanTrialsOfLastSteps(targets); },
    [&] { return PlanTrials(profile, targets, trials); },
    [&] { return between(DecimationOptions::ManyVertices); },
  };
  if (targets.front().Type == LevelTarget::ErrorBound)
  {
    // Results of neighboring steps differ with no visible rule, so that more trials find better
    // ones. Steps of more vertices take longer.
    for (const int mostVertices :
      { DecimationOptions::ManyVertices, DecimationOptions::ManyVertices,
        DecimationOptions::FewVertices, DecimationOptions::FewVertices })
    {
      rounds.push_back([&, mostVertices] { return between(mostVertices); });
    }
  }
  else
  {
    constexpr int tighterRounds = 6; // most targets are done after fewer
    rounds.resize(
      rounds.size() + tighterRounds, [&] { return PlanTighterTrials(profile, targets, trials); });
  }
  if (TriesCoarseStepsFirst(targets))
  {
    std::swap(rounds[0], rounds[1]);
  }
  const double share = 1.0 / rounds.size();
  double done = 0.0;
  for (const auto& plan : rounds)
  {
    if (!runner.Run(targets, plan(), done, done + share))
    {
      return false;
    }
    done += share;
  }
  AddProblems(trials, problems);
  AddBestLevels(trials, targets, carved);
  return true;
}
