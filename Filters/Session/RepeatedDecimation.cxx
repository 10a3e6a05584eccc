// SPDX-License-Identifier: BSD-3-Clause
#include "Session/RepeatedDecimation.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/CornerPoints.h"
#include "Session/TighterTrials.h"

#include <algorithm>
#include <utility>

namespace
{

using carving::DecimatedSurface;
using carving::DecimationOptions;

/**
 * The options for a second run, which has no targets if nothing is to be gained. Numbers that are
 * out of reach are left out: they come last.
 */
DecimationOptions PlanSecondRun(
  const carving::Job& job, double diagonal, const carving::Decimation& first)
{
  DecimationOptions options = job.Decimation;
  options.Targets.clear();
  for (std::size_t i = 0; i < first.Surfaces.size() && first.Surfaces[i].Reached; ++i)
  {
    options.Targets.push_back(job.Decimation.Targets[i]);
    options.Bounds.push_back(FindTighterBound(first.Chain.Vertices, first.Surfaces[i].Error));
  }
  if (!options.Targets.empty())
  {
    constexpr double notVisible = 1e-4; // of the diagonal
    const DecimatedSurface& coarsest = first.Surfaces[options.Targets.size() - 1];
    const bool hasEnough = coarsest.Collapses == 0; // the given surface
    if (hasEnough || coarsest.Error <= notVisible * diagonal)
    {
      options.Targets.clear();
    }
  }
  return options;
}

} // namespace

HelperProcess::Outcome RepeatedDecimation::RunOnce(const carving::Job& job, double begin,
  double end, const HelperProcess::Observer& observer, std::string& error)
{
  carving::Reply reply;
  const HelperProcess::Outcome outcome = HelperProcess::Run(
    job, reply,
    [&](carving::WorkProgress progress)
    {
      progress.Fraction = begin + (end - begin) * progress.Fraction;
      return observer(progress);
    },
    error);
  error = error.empty() ? reply.Error : error;
  this->Results.push_back(std::move(reply.Decimation));
  return outcome == HelperProcess::Outcome::Success && !error.empty()
    ? HelperProcess::Outcome::Failure
    : outcome;
}

HelperProcess::Outcome RepeatedDecimation::Run(
  const carving::Job& job, const HelperProcess::Observer& observer, std::string& error)
{
  constexpr double firstShare = 0.2; // of the time
  const std::vector<carving::Point> points = carving::CornerPoints(job.Mesh);
  const bool mayRepeat = job.Decimation.Type != carving::DecimationTarget::ErrorBound &&
    points.size() <= DecimationOptions::ManyVertices;
  const double begin = mayRepeat ? firstShare : 1.0;
  HelperProcess::Outcome outcome = this->RunOnce(job, 0.0, begin, observer, error);
  if (outcome != HelperProcess::Outcome::Success || !mayRepeat)
  {
    return outcome;
  }
  carving::Job second = job;
  second.Decimation = PlanSecondRun(job, carving::Diagonal(points), this->Results[0]);
  if (second.Decimation.Targets.empty())
  {
    return outcome;
  }
  outcome = this->RunOnce(second, begin, 1.0, observer, error);
  if (outcome == HelperProcess::Outcome::Failure) // the first run has met all targets
  {
    this->Results.pop_back();
    error.clear();
    return HelperProcess::Outcome::Success;
  }
  // Only the surfaces of one run are nested.
  const std::vector<DecimatedSurface>& surfaces = this->Results[1].Surfaces;
  if (job.Decimation.Nested &&
    (surfaces.size() < job.Decimation.Targets.size() ||
      std::any_of(surfaces.begin(), surfaces.end(),
        [](const DecimatedSurface& surface) { return !surface.Reached; })))
  {
    this->Results.pop_back();
  }
  return outcome;
}

RepeatedDecimation::Found RepeatedDecimation::GetClosest(std::size_t target) const
{
  const carving::Decimation *first = &this->Results.front(), *last = &this->Results.back();
  const bool isCloser = target < last->Surfaces.size() && last->Surfaces[target].Reached &&
    last->Surfaces[target].Error < first->Surfaces[target].Error;
  const carving::Decimation& closest = isCloser ? *last : *first;
  return { closest, closest.Surfaces[target] };
}
