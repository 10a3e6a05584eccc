// SPDX-License-Identifier: BSD-3-Clause
#include "Session/CarvedLeaf.h"

#include "Core/Carving/CellDistances.h"
#include "Core/Measure/StreamError.h"
#include "Core/Measure/StreamTopology.h"
#include "Core/Mesh/ForEach.h"
#include "Core/Solid/Cracks.h"

#include <algorithm>
#include <utility>

namespace
{

/** The regions of the decomposition, unless the helper program has classified them. */
template <int D>
carving::Classification Classify(
  DecomposedLeaf<D>& leaf, const CarverSettings& settings, CarverStages& stages)
{
  if (Kind<D>::IsWithoutSolid(leaf.Reply))
  {
    return std::move(leaf.Reply.Regions);
  }
  const CarverStages::Timer timer(stages, static_cast<int>(carving::Stage::Classify));
  if constexpr (D == 3)
  {
    const int sealed =
      carving::SealCracks(leaf.Reply.Result, settings.Solid, settings.ThreadsOfLeaf);
    if (sealed > 0) // now the result is that of this rule
    {
      leaf.Reply.CracksSealed = sealed;
      leaf.Reply.SolidMatters = 1;
      leaf.Settings.Solid = settings.Solid;
    }
  }
  return carving::Classify(Kind<D>::GetResult(leaf.Reply), settings.Solid, settings.ThreadsOfLeaf);
}

/** Carves. Returns false if the filter is to stop. */
template <int D>
bool Carve(const carving::Decomposition<D>& mesh, const carving::Classification& regions,
  const CarverSettings& settings, CarverStages& stages, carving::Stream& stream)
{
  carving::CarveOptions options = settings.Carve;
  options.Threads = settings.ThreadsOfLeaf;
  if (settings.DepthIsDistance)
  {
    options.Depths = carving::MeasureDepths(mesh, regions, settings.ThreadsOfLeaf);
  }
  return carving::Carve(mesh, regions, options, stream,
    [&stages](double fraction) { return stages.Report(CarveStage, fraction); });
}

/** Moves the mesh and the stream if the mesh is without the solid, and else copies. */
template <int D>
carving::StoredStream<D> Store(
  DecomposedLeaf<D>& leaf, const carving::Classification& regions, carving::Stream& stream)
{
  if constexpr (D == 3)
  {
    if (!regions.SolidRegions.empty())
    {
      return carving::Store(std::move(leaf.Reply.Result), regions, std::move(stream));
    }
  }
  return carving::Store(Kind<D>::GetResult(leaf.Reply), regions, stream);
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
  const bool isMoved = !regions.SolidRegions.empty();
  const carving::Decomposition<D>& mesh =
    isMoved ? carved.Stream.Mesh : Kind<D>::GetResult(leaf.Reply);
  carving::StreamTopology topology;
  carving::ForEach(settings.ThreadsOfLeaf, 2,
    [&](int part)
    {
      if (part == 0)
      {
        topology = carving::ComputeTopology(mesh, regions, isMoved ? carved.Stream.Order : stream);
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
  const carving::ResolvedInput<D>& unresolved = mesh.Unresolved;
  const bool conforming = unresolved.Facets.empty();
  return carving::ComputeErrors(carved.Stream, conforming ? carved.Stream.Mesh.Surface : unresolved,
    conforming, carved.Profile.Error,
    [&stages](double fraction) { return stages.Report(MeasureStage, fraction); });
}

} // namespace

template <int D>
bool CarveLeaf(DecomposedLeaf<D>& leaf, const CarverSettings& settings, CarverStages& stages,
  CarvedLeaf<D>& carved)
{
  const carving::Classification regions = Classify(leaf, settings, stages);
  carved.GuessedRegions = static_cast<int>(std::count_if(regions.Regions.begin(),
    regions.Regions.end(), [](const carving::Region& region) { return region.Guessed; }));
  if (!stages.Report(static_cast<int>(carving::Stage::Classify), 1.0))
  {
    return false;
  }
  carving::Stream stream;
  {
    const CarverStages::Timer timer(stages, CarveStage);
    if (!Carve(Kind<D>::GetResult(leaf.Reply), regions, settings, stages, stream))
    {
      return false;
    }
    if (carving::HasLimits(settings.Carve.Budget))
    {
      carved.LeftByBudget = carving::CountLeft(regions, settings.Carve, stream);
    }
    carved.Stream = Store(leaf, regions, stream);
    if constexpr (D == 2)
    {
      leaf.Input.Restore(carved.Stream.Mesh.Surface.Points);
    }
    carved.Stream.Measure = settings.Carve.Measure;
    carved.Stream.Folds = settings.Folds;
  }
  return Measure(leaf, settings, stages, regions, stream, carved);
}

template bool CarveLeaf<2>(
  DecomposedLeaf<2>&, const CarverSettings&, CarverStages&, CarvedLeaf<2>&);
template bool CarveLeaf<3>(
  DecomposedLeaf<3>&, const CarverSettings&, CarverStages&, CarvedLeaf<3>&);
