// SPDX-License-Identifier: BSD-3-Clause
#include "Session/LevelSimplifier.h"

#include "Core/Mesh/Vector.h"
#include "Core/Surface/Manifold.h"
#include "Core/Surface/SurfaceTopology.h"
#include "Process/HelperProcess.h"

#include <algorithm>
#include <cmath>

namespace
{

using carving::operator+;
using carving::operator/;
using carving::DecimatedSurface;
using carving::DecimationTarget;
using carving::LevelTarget;
using carving::SimplifiedTarget;

const carving::ResolvedMesh& GetMesh(const carving::Decomposition<3>& decomposition)
{
  const bool conforming = decomposition.Unresolved.Facets.empty();
  return conforming ? decomposition.Surface : decomposition.Unresolved;
}

std::array<int, 3> GetTopology(const carving::Profile& profile, int step)
{
  return { profile.Components[step], profile.Tunnels[step], profile.Voids[step] };
}

/** The steps up to `last` that trials decimate, fine to coarse, for at least `least` vertices. */
std::vector<int> SelectTrials(const carving::Profile& profile, int last, double least)
{
  std::vector<int> steps = { last };
  const auto begin = profile.Vertices.begin();
  for (double count = profile.Vertices[last] / 2.0; count >= least; count /= 2.0)
  {
    const auto next = std::upper_bound(begin, begin + last + 1, count);
    if (next == begin)
    {
      break; // C0 has more vertices
    }
    const int step = static_cast<int>(next - begin) - 1;
    if (GetTopology(profile, step) != GetTopology(profile, steps.back()))
    {
      steps.push_back(step);
    }
  }
  // Collapses of a convex hull do not stick.
  if (steps.back() != 0 && GetTopology(profile, 0) != GetTopology(profile, steps.back()))
  {
    steps.push_back(0);
  }
  return steps;
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
  , Mesh(GetMesh(leaf.Reply.Result))
  , Distance(this->Mesh)
{
}

/** Returns null if the trial has no surface for the target. */
const DecimatedSurface* LevelSimplifier::Trial::Find(double target) const
{
  const auto found = std::find(this->Targets.begin(), this->Targets.end(), target);
  const std::size_t index = found - this->Targets.begin();
  return index < this->Result.Surfaces.size() ? &this->Result.Surfaces[index] : nullptr;
}

int LevelSimplifier::Trial::CountVertices(const DecimatedSurface& surface) const
{
  return this->Result.Chain.Vertices - surface.Collapses;
}

std::vector<LevelSimplifier::Trial> LevelSimplifier::PlanTrials(
  const std::vector<SimplifiedTarget>& targets) const
{
  const carving::Profile& profile = this->Carved.Profile;
  const LevelTarget type = targets.front().Type;
  std::vector<Trial> trials;
  for (auto first = targets.begin(); first != targets.end();)
  {
    const auto end = std::find_if(first, targets.end(),
      [last = first->LastStep](const SimplifiedTarget& target) { return target.LastStep != last; });
    std::vector<double> values; // from fine to coarse
    for (auto target = end; target-- != first;)
    {
      values.push_back(target->Value);
    }
    const double least = type == LevelTarget::Vertices ? values.back()
      : type == LevelTarget::Triangles                 ? values.back() / 2.0
                                                       : 0.0;
    for (const int step : SelectTrials(profile, first->LastStep, least))
    {
      Trial& trial = trials.emplace_back();
      trial.LastStep = first->LastStep;
      trial.Step = step;
      trial.Targets = values;
    }
    first = end;
  }
  if (type == LevelTarget::ErrorBound)
  {
    return trials;
  }
  // The steps that reach the targets without a collapse: no level is farther from M.
  for (const SimplifiedTarget& target : targets)
  {
    const carving::SelectedStep carved = carving::SelectStep(profile, type, target.Value);
    if (carved.Problem.empty() && carved.Step < target.LastStep)
    {
      Trial& trial = trials.emplace_back();
      trial.LastStep = target.LastStep;
      trial.Step = carved.Step;
      trial.Targets = { target.Value };
    }
  }
  return trials;
}

bool LevelSimplifier::RunTrial(LevelTarget type, double begin, double share, Trial& trial)
{
  const carving::StoredStream<3>& stream = this->Carved.Stream;
  const carving::Level<3> level = carving::ExtractLevel(stream, trial.Step);
  const carving::ManifoldLevel<3> cut = carving::CutIntoManifold(stream, level);
  trial.Points = cut.Points;
  for (const carving::FaceLife<3>& face : level.Faces)
  {
    trial.Cells.push_back(carving::CellWithDataOf(stream, face));
  }
  const carving::SurfaceTopology topology = carving::MeasureSurface(cut);
  trial.SurfaceComponents = topology.Components;
  trial.SurfaceGenus = topology.Genus;
  carving::Job job;
  job.Kind = carving::JobKind::Decimate;
  job.Mesh = { this->Mesh.Points, this->Mesh.Facets };
  job.Surface.Triangles = cut.Faces;
  for (const int point : cut.Points)
  {
    job.Surface.Points.push_back(stream.Mesh.Surface.Points[point]);
  }
  job.Decimation = { AsDecimationTarget(type), trial.Targets, 0 };
  carving::Reply reply;
  const HelperProcess::Outcome outcome = HelperProcess::Run(
    job, reply,
    [&](carving::Stage, double fraction)
    { return this->Stages.Report(SimplifyStage, begin + share * fraction); },
    trial.Error);
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

/** Drops the targets for which an earlier trial has a result that the trial could hardly beat. */
void LevelSimplifier::DropHopelessTargets(
  LevelTarget type, const std::vector<Trial>& trials, Trial& trial) const
{
  const auto bestError = [&](double target)
  {
    double best = HUGE_VAL;
    for (const Trial& earlier : trials)
    {
      const DecimatedSurface* surface = earlier.Find(target);
      if (surface && surface->Reached && earlier.Step <= trial.LastStep)
      {
        best = std::min(best, type == LevelTarget::ErrorBound ? target : surface->Error);
      }
    }
    return best;
  };
  double worst = 0.0;
  for (const double target : trial.Targets)
  {
    worst = std::max(worst, bestError(target));
  }
  const double least = std::isfinite(worst) ? this->FindLeastError(trial.Step, worst) : 0.0;
  trial.Targets.erase(std::remove_if(trial.Targets.begin(), trial.Targets.end(),
                        [&](double target) { return least > bestError(target); }),
    trial.Targets.end());
}

bool LevelSimplifier::RunTrials(
  LevelTarget type, std::vector<Trial>& trials, std::vector<std::string>& problems)
{
  const double share = 1.0 / trials.size();
  for (std::size_t i = 0; i < trials.size(); ++i)
  {
    this->DropHopelessTargets(type, trials, trials[i]);
    if (trials[i].Targets.empty())
    {
      continue;
    }
    if (!this->RunTrial(type, static_cast<double>(i) * share, share, trials[i]))
    {
      return false;
    }
    if (!trials[i].Error.empty())
    {
      problems.push_back("Step " + std::to_string(trials[i].Step) +
        " of the stream cannot be simplified. " + trials[i].Error);
    }
  }
  return true;
}

/** Adds the decimated step of a trial, with its new points, unless that has been done. */
void LevelSimplifier::AddStep(Trial& trial)
{
  if (trial.Index >= 0)
  {
    return;
  }
  std::vector<carving::DecimatedStep>& steps = this->Carved.Simplified.Steps;
  trial.Index = static_cast<int>(steps.size());
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
}

/** Adds the best result for a target, from a step up to `lastStep`, which becomes its step. */
void LevelSimplifier::Choose(
  const SimplifiedTarget& target, std::vector<Trial>& trials, int& lastStep)
{
  Trial* bestTrial = nullptr;
  const DecimatedSurface* best = nullptr;
  const auto isBetter = [&](const Trial& trial, const DecimatedSurface& surface)
  {
    if (surface.Reached != best->Reached)
    {
      return surface.Reached > best->Reached;
    }
    return surface.Reached && target.Type != LevelTarget::ErrorBound
      ? surface.Error < best->Error
      : trial.CountVertices(surface) < bestTrial->CountVertices(*best);
  };
  for (Trial& trial : trials)
  {
    const DecimatedSurface* surface = trial.Find(target.Value);
    if (surface && trial.Step <= std::min(lastStep, target.LastStep) &&
      (!best || isBetter(trial, *surface)))
    {
      bestTrial = &trial;
      best = surface;
    }
  }
  if (best)
  {
    lastStep = bestTrial->Step;
    this->AddStep(*bestTrial);
    this->Carved.Simplified.Levels.push_back(
      { bestTrial->Index, best->Collapses, best->Error, target.LastStep, target.Value });
  }
}

bool LevelSimplifier::Run(const CarverSettings& settings, std::vector<std::string>& problems)
{
  const CarverStages::Timer timer(this->Stages, SimplifyStage);
  const carving::Profile& profile = this->Carved.Profile;
  std::vector<SimplifiedTarget> targets = MakeSimplifiedTargets(profile, settings);
  targets.erase(
    std::remove_if(targets.begin(), targets.end(),
      [&](const SimplifiedTarget& target) { return carving::IsMetByCarving(profile, target); }),
    targets.end());
  if (targets.empty())
  {
    return true;
  }
  std::vector<Trial> trials = this->PlanTrials(targets);
  if (!this->RunTrials(targets.front().Type, trials, problems))
  {
    return false;
  }
  // From fine to coarse. A coarser level never comes from a later step: components only split.
  int lastStep = profile.LastStep();
  for (auto target = targets.rbegin(); target != targets.rend(); ++target)
  {
    this->Choose(*target, trials, lastStep);
  }
  carving::SimplifiedStream& simplified = this->Carved.Simplified;
  simplified.Type = targets.front().Type;
  std::reverse(simplified.Levels.begin(), simplified.Levels.end());
  return true;
}
