// SPDX-License-Identifier: BSD-3-Clause
#include "Session/LevelSimplifier.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Core/Surface/Manifold.h"
#include "Core/Surface/SurfaceTopology.h"
#include "Session/TrialPlans.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>

namespace
{

using carving::operator+;
using carving::operator/;
using carving::DecimationTarget;
using carving::LevelTarget;
using carving::SimplifiedTarget;

const carving::ResolvedMesh& GetMesh(const DecomposedLeaf<3>& leaf, const CarvedLeaf<3>& carved)
{
  const carving::ResolvedMesh& unresolved = leaf.Reply.Result.Unresolved;
  return unresolved.Facets.empty() ? carved.Stream.Mesh.Surface : unresolved;
}

/** A step whose distance from M is more than this share of a result's hardly ever beats it. */
constexpr double Hope = 0.9;

/** Counts the vertices that share their points with others. The points are in ascending order. */
std::size_t CountCopies(const std::vector<int>& points)
{
  std::size_t copies = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    copies += (i > 0 && points[i] == points[i - 1]) ||
      (i + 1 < points.size() && points[i] == points[i + 1]);
  }
  return copies;
}

DecimationTarget AsDecimationTarget(LevelTarget type)
{
  return type == LevelTarget::Triangles ? DecimationTarget::Triangles
    : type == LevelTarget::ErrorBound   ? DecimationTarget::ErrorBound
                                        : DecimationTarget::Vertices;
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

LevelSimplifier::LevelSimplifier(
  const DecomposedLeaf<3>& leaf, CarvedLeaf<3>& carved, CarverStages& stages)
  : Carved(carved)
  , Stages(stages)
  , Mesh(GetMesh(leaf, carved))
  , Diagonal(carving::Diagonal(this->Mesh.Points))
  , Distance(this->Mesh)
{
}

/** Starts to decimate the step of a trial, unless no target is in reach. */
std::optional<HelperProcess> LevelSimplifier::Start(LevelTarget type, LevelTrial& trial) const
{
  const carving::StoredStream<3>& stream = this->Carved.Stream;
  const carving::Level<3> level = carving::ExtractLevel(stream, trial.Step);
  const carving::ManifoldLevel<3> cut = carving::CutIntoManifold(stream, level);
  const carving::SurfaceTopology topology = carving::MeasureSurface(cut);
  trial.SurfaceComponents = topology.Components;
  trial.SurfaceGenus = topology.Genus;
  trial.Points = cut.Points;
  // A closed surface has at least four vertices. In practice, each handle keeps about as many.
  // Vertices at which parts touch are copies of each other. They stay: neither part can move there.
  trial.LeastVertices = std::max(4.0 * topology.Components + 4.0 * std::max(topology.Genus, 0),
    static_cast<double>(CountCopies(cut.Points)));
  if (type != LevelTarget::ErrorBound)
  {
    DropTargetsIf(
      trial, [least = trial.LeastVertices](double value) { return std::max(value, 4.0) < least; });
  }
  if (trial.Targets.empty())
  {
    return std::nullopt;
  }
  for (const carving::FaceLife<3>& face : level.Faces)
  {
    trial.Cells.push_back(carving::CellWithDataOf(stream, face));
  }
  carving::Job job;
  job.Kind = carving::JobKind::Decimate;
  job.Processes = this->Threads;
  job.Mesh = { this->Mesh.Points, this->Mesh.Facets };
  job.Surface.Triangles = cut.Faces;
  for (const int point : cut.Points)
  {
    job.Surface.Points.push_back(stream.Mesh.Surface.Points[point]);
  }
  job.Decimation.Type = AsDecimationTarget(type);
  for (const TrialTarget& target : trial.Targets)
  {
    job.Decimation.Targets.push_back(target.Value);
    if (target.Bound < HUGE_VAL)
    {
      job.Decimation.Bounds.push_back(target.Bound);
    }
  }
  HelperProcess process;
  trial.Error = process.Start(job);
  return trial.Error.empty() ? std::make_optional(std::move(process)) : std::nullopt;
}

/** Waits for the decimated step of a trial. Returns false if the filter is to stop. */
bool LevelSimplifier::Finish(HelperProcess& process, double begin, double end, LevelTrial& trial)
{
  carving::Reply reply;
  const HelperProcess::Outcome outcome = process.Wait([&](const carving::WorkProgress& progress)
    { return this->Stages.Report(SimplifyStage, begin + (end - begin) * progress.Fraction); },
    reply, trial.Error);
  trial.Result = std::move(reply.Decimation);
  trial.Error += reply.Error;
  return outcome != HelperProcess::Outcome::Aborted;
}

/**
 * A lower bound of the distance of C_step from M, sought up to `enough`: the largest distance of a
 * face's centroid.
 */
double LevelSimplifier::FindLeastError(int step, double enough) const
{
  double least = 0.0;
  const std::vector<carving::Point>& points = this->Carved.Stream.Mesh.Surface.Points;
  for (const carving::FaceLife<3>& face : carving::ExtractLevel(this->Carved.Stream, step).Faces)
  {
    if (face.Constraint < 0 && least <= enough)
    {
      const auto& [a, b, c] = face.Corners;
      least = std::max(least, this->Distance.OfPoint((points[a] + points[b] + points[c]) / 3.0));
    }
  }
  return least;
}

/** Drops the targets for which an earlier trial has a result that this one could hardly beat. */
void LevelSimplifier::DropHopelessTargets(const TargetList& targets, LevelTrial& trial) const
{
  if (trial.Step < trial.LastStep && targets.front().Type != LevelTarget::ErrorBound)
  {
    DropTargetsOfLastStep(this->Trials, this->Diagonal, trial);
  }
  const auto bestError = [&](double value)
  {
    const SimplifiedTarget target = { targets.front().Type, trial.LastStep, value, {} };
    const BestTrial best = FindBestTrial(this->Trials, target);
    return !best.Trial || !best.Surface->Reached ? HUGE_VAL
      : target.Type == LevelTarget::ErrorBound   ? value
                                                 : best.Surface->Error;
  };
  double worst = 0.0;
  for (const TrialTarget& target : trial.Targets)
  {
    worst = std::max(worst, bestError(target.Value));
  }
  const double least = std::isfinite(worst) ? this->FindLeastError(trial.Step, Hope * worst) : 0.0;
  DropTargetsIf(trial, [&](double value) { return least > Hope * bestError(value); });
}

/** Runs trials at the same time. Returns false if the filter is to stop. */
bool LevelSimplifier::RunTogether(
  LevelTarget type, double begin, double share, LevelTrial* first, LevelTrial* last)
{
  std::vector<std::optional<HelperProcess>> processes;
  for (LevelTrial* trial = first; trial != last; ++trial)
  {
    processes.push_back(trial->Targets.empty() ? std::nullopt : this->Start(type, *trial));
  }
  for (std::optional<HelperProcess>& process : processes)
  {
    if (process && !this->Finish(*process, begin, begin + share, *first))
    {
      return false;
    }
    begin += share;
    ++first;
  }
  return true;
}

/**
 * Runs trials as a part of the stage, in pairs if a processor is free. Returns false if the filter
 * is to stop.
 */
bool LevelSimplifier::RunTrials(
  const TargetList& targets, std::vector<LevelTrial> trials, double begin, double end)
{
  constexpr std::size_t pair = 2;
  const std::size_t atOnce = this->Threads > 1 ? pair : 1;
  const double share = (end - begin) / std::max<std::size_t>(trials.size(), 1);
  for (std::size_t first = 0; first < trials.size(); first += pair)
  {
    // Before both, so that the results do not depend on the number of threads.
    const std::size_t last = std::min(first + pair, trials.size());
    for (std::size_t i = first; i < last; ++i)
    {
      this->DropHopelessTargets(targets, trials[i]);
    }
    for (std::size_t i = first; i < last; i += atOnce)
    {
      LevelTrial* trial = &trials[i];
      if (!this->RunTogether(targets.front().Type, begin + i * share, share, trial,
            trial + std::min(atOnce, last - i)))
      {
        return false;
      }
    }
    std::move(trials.begin() + first, trials.begin() + last, std::back_inserter(this->Trials));
  }
  return this->Stages.Report(SimplifyStage, end);
}

/** Adds the decimated step of a trial, with its new points. Returns its index. */
int LevelSimplifier::AddStep(const LevelTrial& trial)
{
  std::vector<carving::DecimatedStep>& steps = this->Carved.Simplified.Steps;
  carving::DecimatedStep& step = steps.emplace_back();
  step.Step = trial.Step;
  step.SurfaceComponents = trial.SurfaceComponents;
  step.SurfaceGenus = trial.SurfaceGenus;
  step.Chain = trial.Result.Chain;
  for (carving::ChainFace& face : step.Chain.Faces)
  {
    face.Source = trial.Cells[face.Source];
  }
  carving::ResolvedMesh& surface = this->Carved.Stream.Mesh.Surface;
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

/** Adds the best levels. */
void LevelSimplifier::Choose(const TargetList& targets)
{
  carving::SimplifiedStream& simplified = this->Carved.Simplified;
  simplified.Type = targets.front().Type;
  std::map<const LevelTrial*, int> added;
  const std::vector<BestTrial> chosen = ChooseTrials(this->Trials, targets);
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    const auto& [trial, surface] = chosen[i];
    if (trial)
    {
      const auto found = added.find(trial);
      const int index = found != added.end() ? found->second : this->AddStep(*trial);
      added[trial] = index;
      simplified.Levels.push_back(
        { index, surface->Collapses, surface->Error, targets[i].LastStep, targets[i].Value });
    }
  }
  // For numbers beyond the targets.
  const auto last = std::find_if(this->Trials.begin(), this->Trials.end(),
    [&](const LevelTrial& trial)
    { return trial.Step == targets.back().LastStep && !trial.Result.Surfaces.empty(); });
  if (last != this->Trials.end() && added.find(&*last) == added.end())
  {
    this->AddStep(*last);
  }
}

bool LevelSimplifier::Run(const CarverSettings& settings, std::vector<std::string>& problems)
{
  const CarverStages::Timer timer(this->Stages, SimplifyStage);
  const carving::Profile& profile = this->Carved.Profile;
  TargetList targets = MakeSimplifiedTargets(profile, settings);
  targets.erase(
    std::remove_if(targets.begin(), targets.end(),
      [&](const SimplifiedTarget& target) { return carving::IsMetByCarving(profile, target); }),
    targets.end());
  if (targets.empty())
  {
    return true;
  }
  this->Threads = settings.ThreadsOfLeaf;
  // Results of neighboring steps differ with no visible rule, so that more trials find better ones.
  constexpr int anyNumber = std::numeric_limits<int>::max();
  const auto between = [&](int mostVertices)
  { return PlanTrialsBetween(profile, targets, this->Trials, mostVertices); };
  const std::function<std::vector<LevelTrial>()> rounds[] = {
    [&] { return PlanTrialsOfLastSteps(targets); },
    [&] { return PlanTrials(profile, targets); },
    [&] { return between(anyNumber); },
    [&] { return between(anyNumber); },
    [&] { return between(anyNumber); },
    [&] { return between(carving::DecimationOptions::FewVertices); },
    [&] { return between(carving::DecimationOptions::FewVertices); },
    [&] { return PlanTighterTrials(profile, targets, this->Trials, this->Diagonal); },
  };
  const double share = 1.0 / std::size(rounds);
  double done = 0.0;
  for (const auto& plan : rounds)
  {
    if (!this->RunTrials(targets, plan(), done, done + share))
    {
      return false;
    }
    done += share;
  }
  for (const LevelTrial& trial : this->Trials)
  {
    if (!trial.Error.empty())
    {
      problems.push_back("Step " + std::to_string(trial.Step) +
        " of the stream cannot be simplified. " + trial.Error);
    }
  }
  this->Choose(targets);
  return true;
}
