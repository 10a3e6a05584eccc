// SPDX-License-Identifier: BSD-3-Clause
#include "Session/LevelSimplifier.h"

#include "Core/Measure/LevelSelection.h"
#include "Core/Surface/Manifold.h"
#include "Process/HelperProcess.h"

#include <algorithm>
#include <sstream>

namespace
{

using carving::DecimatedSurface;
using carving::DecimationTarget;

carving::TriangleMesh GetMesh(const carving::Decomposition<3>& decomposition)
{
  const bool conforming = decomposition.Unresolved.Facets.empty();
  const carving::ResolvedMesh& mesh = conforming ? decomposition.Surface : decomposition.Unresolved;
  return { mesh.Points, mesh.Facets };
}

std::array<int, 3> GetTopology(const carving::Profile& profile, int step)
{
  return { profile.Components[step], profile.Tunnels[step], profile.Voids[step] };
}

/** The steps up to `last` that trials decimate, from fine to coarse, for at least `least` vertices. */
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

bool IsBetter(DecimationTarget type, const DecimatedSurface& a, const DecimatedSurface& b)
{
  if (a.Reached != b.Reached)
  {
    return a.Reached > b.Reached;
  }
  const bool byError = a.Reached && type != DecimationTarget::ErrorBound;
  return byError ? a.Error < b.Error : a.Mesh.Points.size() < b.Mesh.Points.size();
}

} // namespace

LevelSimplifier::LevelSimplifier(
  const DecomposedLeaf<3>& leaf, const CarvedLeaf<3>& carved, CarverStages& stages)
  : Carved(carved)
  , Stages(stages)
  , Mesh(GetMesh(leaf.Reply.Result))
{
}

std::vector<LevelSimplifier::Trial> LevelSimplifier::PlanTrials(
  DecimationTarget type, const std::vector<Request>& requests) const
{
  std::vector<Trial> trials;
  for (auto first = requests.begin(); first != requests.end();)
  {
    const auto end = std::find_if(first, requests.end(),
      [last = first->LastStep](const Request& request) { return request.LastStep != last; });
    std::vector<double> targets;
    for (auto request = end; request-- != first;)
    {
      targets.push_back(request->Target);
    }
    const double least = type == DecimationTarget::Vertices ? targets.back()
      : type == DecimationTarget::Triangles                 ? targets.back() / 2.0
                                                            : 0.0;
    for (const int step : SelectTrials(this->Carved.Profile, first->LastStep, least))
    {
      Trial& trial = trials.emplace_back();
      trial.Step = step;
      trial.Targets = targets;
    }
    first = end;
  }
  if (type == DecimationTarget::ErrorBound)
  {
    return trials;
  }
  // The steps that reach the targets without a collapse: no level is farther from M.
  const carving::LevelTarget count = type == DecimationTarget::Vertices
    ? carving::LevelTarget::Vertices
    : carving::LevelTarget::Triangles;
  for (const Request& request : requests)
  {
    const carving::SelectedStep carved =
      carving::SelectStep(this->Carved.Profile, count, request.Target);
    if (carved.Problem.empty() && carved.Step < request.LastStep)
    {
      Trial& trial = trials.emplace_back();
      trial.Step = carved.Step;
      trial.Targets = { request.Target };
    }
  }
  return trials;
}

bool LevelSimplifier::RunTrial(DecimationTarget type, double begin, double share, Trial& trial)
{
  const carving::Level<3> level = carving::ExtractLevel(this->Carved.Stream, trial.Step);
  const carving::ManifoldLevel<3> cut = carving::CutIntoManifold(this->Carved.Stream, level);
  trial.Points = cut.Points;
  trial.Faces = level.Faces;
  carving::Job job;
  job.Kind = carving::JobKind::Decimate;
  job.Mesh = this->Mesh;
  job.Surface.Triangles = cut.Faces;
  for (const int point : cut.Points)
  {
    job.Surface.Points.push_back(this->Carved.Stream.Mesh.Surface.Points[point]);
  }
  job.Decimation = { type, trial.Targets, 0 };
  carving::Reply reply;
  const HelperProcess::Outcome outcome = HelperProcess::Run(
    job, reply,
    [&](carving::Stage, double fraction)
    { return this->Stages.Report(SimplifyStage, begin + share * fraction); },
    trial.Error);
  trial.Results = std::move(reply.Surfaces);
  trial.Error += reply.Error;
  return outcome != HelperProcess::Outcome::Aborted;
}

SimplifiedLevel LevelSimplifier::MakeLevel(const Trial& trial, const DecimatedSurface& surface)
{
  SimplifiedLevel level;
  level.Step = trial.Step;
  level.Mesh = surface.Mesh;
  level.Error = surface.Error;
  for (const int source : surface.PointSources)
  {
    level.Points.push_back(source < 0 ? -1 : trial.Points[source]);
  }
  for (const int source : surface.FacetSources)
  {
    level.Faces.push_back(trial.Faces[source]);
  }
  return level;
}

bool LevelSimplifier::Run(DecimationTarget type, const std::vector<Request>& requests,
  std::vector<SimplifiedLevel>& levels, std::vector<std::string>& problems)
{
  const CarverStages::Timer timer(this->Stages, SimplifyStage);
  std::vector<Trial> trials = this->PlanTrials(type, requests);
  for (std::size_t i = 0; i < trials.size(); ++i)
  {
    if (!this->RunTrial(
          type, static_cast<double>(i) / trials.size(), 1.0 / trials.size(), trials[i]))
    {
      return false;
    }
    if (!trials[i].Error.empty())
    {
      problems.push_back("Step " + std::to_string(trials[i].Step) +
        " of the stream cannot be simplified. " + trials[i].Error);
    }
  }
  // From fine to coarse. A coarser level never comes from a later step: components only split.
  int lastStep = this->Carved.Profile.LastStep();
  for (auto request = requests.rbegin(); request != requests.rend(); ++request)
  {
    const Trial* bestTrial = nullptr;
    const DecimatedSurface* best = nullptr;
    for (const Trial& trial : trials)
    {
      const auto target = std::find(trial.Targets.begin(), trial.Targets.end(), request->Target);
      const std::size_t index = target - trial.Targets.begin();
      if (trial.Step <= std::min(lastStep, request->LastStep) && index < trial.Results.size() &&
        (!best || IsBetter(type, trial.Results[index], *best)))
      {
        bestTrial = &trial;
        best = &trial.Results[index];
      }
    }
    levels.insert(levels.begin(), best ? MakeLevel(*bestTrial, *best) : SimplifiedLevel());
    lastStep = best ? bestTrial->Step : lastStep;
    if (best && !best->Reached)
    {
      std::ostringstream problem;
      problem << "The target of " << request->Target << " is out of reach: the coarsest level has "
              << best->Mesh.Points.size() << " vertices.";
      problems.push_back(problem.str());
    }
  }
  return true;
}
