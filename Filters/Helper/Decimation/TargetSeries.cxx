// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/TargetSeries.h"

#include "Helper/Decimation/BoundSearch.h"
#include "Helper/Decimation/HeightBound.h"
#include "Helper/Decimation/Hope.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>

namespace carving::helper
{
namespace
{

/**
 * Above so many vertices, the positions that fit less well remove hardly one vertex in two hundred
 * within an error bound, for a third of the time.
 */
constexpr double MostToTryHarder = 2000.0;

/**
 * At the greatest bound, there is no other way to reach a number: these positions are tried up to
 * this multiple of the number.
 */
constexpr double MostAboveTargetAtLast = 1.6;

/** Each later round would gain little. */
constexpr int TighteningRounds = 2;

/** An upper bound of the largest distance of any point of the surface from a mesh. */
double MeasureError(
  const TriangleMesh& surface, const FaceDistance<3>& distance, HeightBound& heights)
{
  const auto cornersOf = [&](std::size_t i)
  { return carving::CornersOf<3>(surface.Points, surface.Triangles[i]); };
  // A sample finds a face that is about as far as any: then it is cheaper to show that the others
  // are not farther.
  constexpr std::size_t sampled = 16;
  std::size_t farthest = 0;
  double lower = 0.0;
  for (std::size_t i = 0; i < surface.Triangles.size(); i += sampled)
  {
    const double known = distance.Compute(cornersOf(i), 1).Lower;
    if (known > lower)
    {
      lower = known;
      farthest = i;
    }
  }
  double largest = distance.Compute(cornersOf(farthest), MostDistanceQueries).Upper;
  int nearby = -1; // the last face is often a neighbor
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const FacetCorners<3> face = cornersOf(i);
    const FacetTree<3>::Closest closest =
      distance.GetTree().Find((face[0] + face[1] + face[2]) / 3.0, 0.0, nearby);
    nearby = closest.Item;
    if (!heights.IsWithin(face, largest, nearby))
    {
      const FacetCorners<3> start = distance.GetTree().GetItems().CornersOf(nearby);
      largest =
        std::max(largest, distance.Compute(face, MostDistanceQueries, largest, &start).Upper);
    }
  }
  return largest;
}

/** One run of DecimateToTargets. */
class TargetSeries
{
public:
  TargetSeries(Decimator& decimator, const FaceDistance<3>& fromM, const DecimationOptions& options,
    const Progress& report, int threads, std::vector<DecimatedSurface>& results)
    : TheDecimator(decimator)
    , FromM(fromM)
    , Heights(fromM.GetTree().GetItems().GetMesh())
    , Options(options)
    , Report(report)
    , Threads(threads)
    , Results(results)
  {
  }

  std::string Run();

private:
  bool Reach(std::size_t i);
  bool ReachWithinBound(double target, bool isGreatestBound);
  void BeginToMeasure();
  void FinishMeasuring();

  bool IsByError() const
  {
    return this->Options.Type == DecimationTarget::ErrorBound;
  }

  /** The number that targets limit. */
  double Count() const
  {
    const SurfaceMesh& surface = this->TheDecimator.GetSurface();
    return this->Options.Type == DecimationTarget::Triangles ? surface.number_of_faces()
                                                             : surface.number_of_vertices();
  }

  /** Reports progress from time to time. Returns whether the work may go on. */
  bool MayGoOn()
  {
    const double left =
      std::log(static_cast<double>(this->TheDecimator.GetSurface().number_of_vertices()));
    this->Stopped = this->Stopped ||
      (++this->Calls % 1024 == 0 && !GoOn(this->Report, 1.0 - left / this->AtStart));
    return !this->Stopped;
  }

  Decimator& TheDecimator;
  const FaceDistance<3>& FromM;
  HeightBound Heights; ///< above M
  const DecimationOptions& Options;
  const Progress& Report;
  int Threads;
  std::vector<DecimatedSurface>& Results;

  double AtStart = 0.0;  ///< the logarithm of the number of vertices
  double OwnError = 0.0; ///< of the surface as given, if there are bounds
  long long Calls = 0;
  bool Stopped = false;
  std::future<double> Error; ///< of the last result, measured while the next one is made
};

std::string TargetSeries::Run()
{
  const SurfaceMesh& surface = this->TheDecimator.GetSurface();
  this->AtStart = std::log(static_cast<double>(surface.number_of_vertices()));
  this->OwnError = this->Options.Bounds.empty()
    ? 0.0
    : MeasureError(AsTriangleMesh(surface), this->FromM, this->Heights);
  for (std::size_t i = 0; i < this->Options.Targets.size(); ++i)
  {
    const bool reached = this->Reach(i);
    // Bounds are below the distance of a known result, which is better than one that misses a
    // number.
    const bool isOfUse = reached || this->Options.Bounds.empty();
    for (int round = 0; round < TighteningRounds && isOfUse && !this->Stopped; ++round)
    {
      this->TheDecimator.Tighten([this] { return this->MayGoOn(); });
    }
    if (this->Stopped)
    {
      return "stopped";
    }
    this->FinishMeasuring();
    this->Results.push_back({ this->TheDecimator.GetNumberOfCollapses(), reached, 0.0 });
    this->BeginToMeasure();
  }
  this->FinishMeasuring();
  return {};
}

/**
 * Collapses edges within bounds, the least first, down to a target. Returns whether it is reached.
 */
bool TargetSeries::Reach(std::size_t i)
{
  const double target = this->Options.Targets[i];
  if (this->IsByError())
  {
    // The measured error may be 1 % too large; it has to be within the bound, too.
    this->TheDecimator.RaiseErrorBound(target / 1.01);
    return this->ReachWithinBound(target, true);
  }
  const std::vector<double>& bounds = this->Options.Bounds;
  const double greatest =
    bounds.empty() ? HUGE_VAL : *std::max_element(bounds.begin(), bounds.begin() + i + 1);
  BoundSearch search(greatest, this->OwnError);
  std::optional<double> bound = search.First();
  bool reached = false;
  while (bound && !reached && !this->Stopped)
  {
    this->TheDecimator.RaiseErrorBound(*bound);
    reached = this->ReachWithinBound(target, *bound >= greatest);
    bound = search.Next(this->TheDecimator.GetErrorBound(), this->Count() / target);
  }
  return reached;
}

/** Collapses edges within the present bound. Returns whether the target is reached. */
bool TargetSeries::ReachWithinBound(double target, bool isGreatestBound)
{
  const bool isBounded = std::isfinite(this->TheDecimator.GetErrorBound());
  bool hopeless = false;
  Hope hope(target);
  const auto goesOn = [&]
  {
    hopeless = this->Options.GivesUp && !isBounded && this->TheDecimator.TriesAllPositions() &&
      !hope.GoesOn(this->Count());
    return this->MayGoOn() && !hopeless && (this->IsByError() || this->Count() > target);
  };
  const auto triesHarder = [&]
  {
    if (this->IsByError())
    {
      return this->Count() <= MostToTryHarder;
    }
    const double most = isGreatestBound ? MostAboveTargetAtLast : MostAboveTarget;
    return !isBounded || this->Count() <= most * target;
  };
  return this->TheDecimator.Run(goesOn, triesHarder) && !hopeless;
}

void TargetSeries::BeginToMeasure()
{
  this->Error = std::async(
    this->Threads > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred,
    [this, copy = AsTriangleMesh(this->TheDecimator.GetSurface())]
    { return MeasureError(copy, this->FromM, this->Heights); });
  if (this->Threads <= 1)
  {
    this->FinishMeasuring();
  }
}

void TargetSeries::FinishMeasuring()
{
  if (this->Error.valid())
  {
    DecimatedSurface& result = this->Results.back();
    result.Error = this->Error.get();
    if (this->IsByError())
    {
      result.Reached = result.Error <= this->Options.Targets[this->Results.size() - 1];
    }
  }
}

} // namespace

std::string DecimateToTargets(Decimator& decimator, const FaceDistance<3>& fromM,
  const DecimationOptions& options, const Progress& progress, int threads,
  std::vector<DecimatedSurface>& results)
{
  return TargetSeries(decimator, fromM, options, progress, threads, results).Run();
}

} // namespace carving::helper
