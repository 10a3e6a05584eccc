// SPDX-License-Identifier: BSD-3-Clause
#include "Session/CarvedLeaf.h"

#include "Convert/InitialDistance.h"
#include "Core/Measure/StreamError.h"
#include "Core/Measure/StreamTopology.h"
#include "Core/Mesh/ForEach.h"

#include <algorithm>
#include <utility>

namespace
{

/** Classifies and carves. Returns false if the filter is to stop. */
template <int D>
bool Carve(const DecomposedLeaf<D>& leaf, const CarverSettings& settings, CarverStages& stages,
  carving::Classification& regions, carving::Stream& stream, CarvedLeaf<D>& carved)
{
  const carving::Decomposition<D>& mesh = Kind<D>::GetResult(leaf.Reply);
  {
    const CarverStages::Timer timer(stages, ClassifyStage);
    regions = carving::Classify(mesh, settings.Solid, settings.ThreadsOfLeaf);
  }
  carved.GuessedRegions = static_cast<int>(std::count_if(regions.Regions.begin(),
    regions.Regions.end(), [](const carving::Region& region) { return region.Guessed; }));
  if (!stages.Report(ClassifyStage, 1.0))
  {
    return false;
  }
  const CarverStages::Timer timer(stages, CarveStage);
  carving::CarveOptions options = settings.Carve;
  if (settings.DepthIsDistance)
  {
    options.Depths = ComputeInitialDistances(mesh);
  }
  if (!carving::Carve(mesh, regions, options, stream,
        [&stages](double fraction) { return stages.Report(CarveStage, fraction); }))
  {
    return false;
  }
  if (carving::HasLimits(options.Budget))
  {
    carved.LeftByBudget = carving::CountLeft(regions, options, stream);
  }
  carved.Stream = carving::Store(mesh, regions, stream);
  if constexpr (D == 2)
  {
    leaf.Input.Restore(carved.Stream.Mesh.Surface.Points);
  }
  carved.Stream.Measure = options.Measure;
  carved.Stream.Folds = settings.Folds;
  return true;
}

/**
 * Fills the profile, with errors if the settings ask for them. Returns false if the filter is to
 * stop.
 */
template <int D>
bool Measure(const DecomposedLeaf<D>& leaf, const CarverSettings& settings, CarverStages& stages,
  const carving::Classification& regions, const carving::Stream& stream, CarvedLeaf<D>& carved)
{
  const CarverStages::Timer timer(stages, MeasureStage);
  carving::StreamTopology topology;
  carving::ForEach(settings.ThreadsOfLeaf, 2,
    [&](int part)
    {
      if (part == 0)
      {
        topology = carving::ComputeTopology(Kind<D>::GetResult(leaf.Reply), regions, stream);
      }
      else
      {
        carved.Profile = carving::ComputeProfile(carved.Stream);
      }
    });
  static_cast<carving::StreamTopology&>(carved.Profile) = std::move(topology);
  const bool byTarget =
    !settings.LevelTargets.empty() && settings.TargetType == carving::LevelTarget::ErrorBound;
  if (!settings.ComputeError && !byTarget)
  {
    return true;
  }
  const carving::ResolvedInput<D>& unresolved = Kind<D>::GetResult(leaf.Reply).Unresolved;
  const bool conforming = unresolved.Facets.empty();
  return carving::ComputeErrors(carved.Stream, conforming ? carved.Stream.Mesh.Surface : unresolved,
    conforming, carved.Profile.Error,
    [&stages](double fraction) { return stages.Report(MeasureStage, fraction); });
}

} // namespace

template <int D>
bool CarveLeaf(const DecomposedLeaf<D>& leaf, const CarverSettings& settings, CarverStages& stages,
  CarvedLeaf<D>& carved)
{
  carving::Classification regions;
  carving::Stream stream;
  return Carve(leaf, settings, stages, regions, stream, carved) &&
    Measure(leaf, settings, stages, regions, stream, carved);
}

template bool CarveLeaf<2>(
  const DecomposedLeaf<2>&, const CarverSettings&, CarverStages&, CarvedLeaf<2>&);
template bool CarveLeaf<3>(
  const DecomposedLeaf<3>&, const CarverSettings&, CarverStages&, CarvedLeaf<3>&);
