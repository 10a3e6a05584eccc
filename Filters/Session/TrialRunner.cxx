// SPDX-License-Identifier: BSD-3-Clause
#include "Session/TrialRunner.h"

#include "Core/Surface/LevelParts.h"
#include "Core/Surface/Manifold.h"
#include "Core/Surface/SurfaceTopology.h"
#include "Core/Surface/TouchingVertices.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{

using carving::DecimationTarget;
using carving::LevelTarget;
using carving::SimplifiedTarget;

const carving::ResolvedMesh& GetMesh(
  const DecomposedLeaf<3>& leaf, const carving::StoredStream<3>& stream)
{
  const carving::ResolvedMesh& unresolved = leaf.Reply.Result.Unresolved;
  return unresolved.Facets.empty() ? stream.Mesh.Surface : unresolved;
}

/** A step farther from M than this share of the best result's distance seldom beats that result. */
constexpr double Hope = 0.9;

/**
 * The number of vertices at which a step is likely to stick, as a multiple of its LeastVertices:
 * the least multiple at which a trial without bounds has stuck. 1 if none has stuck.
 */
double FindLeastKept(const std::vector<LevelTrial>& trials)
{
  constexpr double most = 1.3; // pits keep many more vertices, but not in every step
  double least = HUGE_VAL;
  for (const LevelTrial& trial : trials)
  {
    const std::vector<carving::DecimatedSurface>& surfaces = trial.Result.Surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
      if (!surfaces[i].Reached && std::isinf(trial.Targets[i].Bound))
      {
        least = std::min(least, CountVertices(trial, surfaces[i]) / trial.LeastVertices);
      }
    }
  }
  return std::isinf(least) ? 1.0 : std::clamp(least, 1.0, most);
}

/** The number of vertices of the best result for a target; infinite if none has reached it. */
double FewestVertices(const std::vector<LevelTrial>& trials, const SimplifiedTarget& target)
{
  const BestTrial best = FindBestTrial(trials, target);
  return best.Trial && HasReached(*best.Surface, target) ? CountVertices(*best.Trial, *best.Surface)
                                                         : HUGE_VAL;
}

DecimationTarget AsDecimationTarget(LevelTarget type)
{
  return type == LevelTarget::Triangles ? DecimationTarget::Triangles
    : type == LevelTarget::ErrorBound   ? DecimationTarget::ErrorBound
                                        : DecimationTarget::Vertices;
}

} // namespace

TrialRunner::TrialRunner(
  const DecomposedLeaf<3>& leaf, const CarvedLeaf<3>& carved, int threads, CarverStages& stages)
  : Stream(carved.Stream)
  , Profile(carved.Profile)
  , Stages(stages)
  , Mesh(GetMesh(leaf, carved.Stream))
  , Diagonal(carving::Diagonal(this->Mesh))
  , Distance(this->Mesh)
  , Threads(threads)
{
}

/** Starts to decimate the step of a trial, unless no target is in reach. */
std::optional<HelperProcess> TrialRunner::Start(
  LevelTarget type, int threads, LevelTrial& trial) const
{
  const carving::StoredStream<3>& stream = this->Stream;
  const carving::Level<3> level = carving::ExtractLevel(stream, trial.Step);
  const carving::ManifoldLevel<3> cut = carving::CutIntoManifold(stream, level);
  const carving::SurfaceTopology topology = carving::MeasureSurface(cut);
  trial.SurfaceComponents = topology.Components;
  trial.SurfaceGenus = topology.Genus;
  trial.Points = cut.Points;
  // A closed surface has at least four vertices. In practice, each handle keeps about as many.
  // Vertices at which parts touch stay: neither part can move there.
  trial.VerticesThatTouch = carving::CountTouchingVertices(stream, level, cut);
  trial.LeastVertices = std::max(4.0 * topology.Components + 4.0 * std::max(topology.Genus, 0),
    static_cast<double>(trial.VerticesThatTouch));
  DropTargetsIf(trial,
    [&, least = FindLeastKept(this->Trials) * trial.LeastVertices](const TrialTarget& target)
    {
      return type == LevelTarget::ErrorBound ? trial.LeastVertices >=
          FewestVertices(this->Trials, { type, trial.LastStep, target.Value, {} })
                                             : std::max(target.Value, 4.0) < least;
    });
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
  job.Processes = threads;
  job.Mesh = { this->Mesh.Points, this->Mesh.Facets };
  job.Parts = carving::ExtractParts(stream, level, this->Mesh.Points.size());
  job.Surface.Triangles = cut.Faces;
  for (const int point : cut.Points)
  {
    job.Surface.Points.push_back(stream.Mesh.Surface.Points[point]);
  }
  job.Decimation.Type = AsDecimationTarget(type);
  job.Decimation.GivesUp = trial.Step > 0; // C0 is the last resort
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
bool TrialRunner::Finish(HelperProcess& process, double begin, double end, LevelTrial& trial)
{
  carving::Reply reply;
  const HelperProcess::Outcome outcome = process.Wait([&](const carving::WorkProgress& progress)
    { return this->Stages.Report(SimplifyStage, begin + (end - begin) * progress.Fraction); },
    reply, trial.Error);
  trial.Result = std::move(reply.Decimation);
  trial.Error = trial.Error.empty() ? reply.Error : trial.Error;
  return outcome != HelperProcess::Outcome::Aborted;
}

/** A lower bound of the distance of C_step from M, sought up to `enough`. */
double TrialRunner::FindLeastError(int step, double enough) const
{
  constexpr int queries = 16; // per face: its farthest point is often on an edge
  double least = 0.0;
  const std::vector<carving::Point>& points = this->Stream.Mesh.Surface.Points;
  for (const carving::FaceLife<3>& face : carving::ExtractLevel(this->Stream, step).Faces)
  {
    if (face.Constraint < 0 && least <= enough)
    {
      const auto corners = carving::CornersOf<3>(points, face.Corners);
      least = std::max(least, this->Distance.Compute(corners, queries, least).Lower);
    }
  }
  return least;
}

/** Drops the targets for which an earlier trial has a result that this one could hardly beat. */
void TrialRunner::DropHopelessTargets(
  const std::vector<SimplifiedTarget>& targets, LevelTrial& trial) const
{
  if (targets.front().Type == LevelTarget::ErrorBound)
  {
    return; // no step is planned that is much too far
  }
  if (trial.Step < trial.LastStep)
  {
    const std::vector<int>& counts = targets.front().Type == LevelTarget::Triangles
      ? this->Profile.Triangles
      : this->Profile.Vertices;
    DropTargetsOfLastStep(this->Trials, this->Diagonal, counts[trial.Step], trial);
  }
  const auto mostError = [&](const TrialTarget& wanted)
  {
    const SimplifiedTarget target = { targets.front().Type, trial.LastStep, wanted.Value, {} };
    const BestTrial best = FindBestTrial(this->Trials, target);
    return std::isfinite(wanted.Bound)      ? wanted.Bound
      : best.Trial && best.Surface->Reached ? Hope * best.Surface->Error
                                            : HUGE_VAL;
  };
  double most = 0.0;
  for (const TrialTarget& target : trial.Targets)
  {
    most = std::max(most, mostError(target));
  }
  const double least = std::isfinite(most) ? this->FindLeastError(trial.Step, most) : 0.0;
  DropTargetsIf(trial, [&](const TrialTarget& target) { return least > mostError(target); });
}

/** Runs trials at the same time. Returns false if the filter is to stop. */
bool TrialRunner::RunTogether(
  LevelTarget type, double begin, double share, LevelTrial* first, LevelTrial* last)
{
  const auto count =
    std::count_if(first, last, [](const LevelTrial& trial) { return !trial.Targets.empty(); });
  const int threads = std::max(1, this->Threads / std::max(1, static_cast<int>(count)));
  std::vector<std::optional<HelperProcess>> processes;
  for (LevelTrial* trial = first; trial != last; ++trial)
  {
    processes.push_back(trial->Targets.empty() ? std::nullopt : this->Start(type, threads, *trial));
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

bool TrialRunner::Run(const std::vector<SimplifiedTarget>& targets, std::vector<LevelTrial> trials,
  double begin, double end)
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
