// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/EnclosingDecimation.h"

#include "Core/Mesh/FaceDistance.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Decimation/BoundSearch.h"
#include "Helper/Decimation/ClosedSurface.h"
#include "Helper/Decimation/Decimator.h"
#include "Helper/Decimation/Hope.h"
#include "Helper/Resolve/Clean.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>
#include <utility>

namespace carving::helper
{
namespace
{

/**
 * A surface within an error bound that has more vertices hardly loses one in two hundred of them by
 * positions that fit less well. These positions take a third of the time.
 */
constexpr double MostToTryHarder = 2000.0;

/** The same for the greatest bound, after which there is no other way to reach a number. */
constexpr double MostAboveTargetAtLast = 1.6;

/** Each later round would gain little. */
constexpr int TighteningRounds = 2;

bool HasFlatTriangle(const ResolvedMesh& mesh)
{
  return std::any_of(mesh.Facets.begin(), mesh.Facets.end(),
    [&](const Triangle& t)
    {
      return CGAL::collinear(
        ToInexact(mesh.Points[t[0]]), ToInexact(mesh.Points[t[1]]), ToInexact(mesh.Points[t[2]]));
    });
}

/** Takes the surface as given if it is closed, and else with equal points merged. */
std::string Prepare(const TriangleMesh& given, ResolvedMesh& surface)
{
  surface = AsResolved(given);
  if (!HasFlatTriangle(surface) && MakeClosedSurface(surface).empty())
  {
    return {};
  }
  surface = Clean(AsResolved(given));
  return MakeClosedSurface(surface);
}

/** A mesh together with the parts of its triangles, cleaned. */
ResolvedMesh JoinMeshes(const TriangleMesh& mesh, const TriangleMesh& parts)
{
  TriangleMesh all = mesh;
  const auto own = static_cast<int>(mesh.Points.size());
  all.Points.insert(all.Points.end(), parts.Points.begin(), parts.Points.end());
  for (const auto& [a, b, c] : parts.Triangles)
  {
    all.Triangles.push_back({ own + a, own + b, own + c });
  }
  return Clean(AsResolved(all));
}

/** Hands on the history in terms of the given surface. */
void HandOn(ChainRecorder history, const ResolvedMesh& original, Decimation& result)
{
  std::move(history).Take(result.Chain, result.Points);
  for (ChainFace& face : result.Chain.Faces)
  {
    face.Source = original.FacetSources[face.Source];
  }
  result.PointSources = original.PointSources;
  result.PointSources.resize(result.Points.size(), -1);
}

/** An upper bound of the largest distance of any point of the surface from a mesh. */
double MeasureError(const TriangleMesh& surface, const FaceDistance<3>& distance)
{
  const auto cornersOf = [&](std::size_t i)
  {
    const auto [a, b, c] = surface.Triangles[i];
    return std::array<Point, 3>{ surface.Points[a], surface.Points[b], surface.Points[c] };
  };
  // Up to some thousand decide. Only slivers in one plane with many facets need more, up to billions.
  // They are very close to the mesh then, so that their bound may be more than 1 % too large.
  constexpr int mostQueries = 20000;
  // A sample finds a face that is about as far as any: then it takes few queries to show that the
  // others are not farther.
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
  FaceDistance<3>::Bound last = distance.Compute(cornersOf(farthest), mostQueries);
  double largest = last.Upper;
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    last = distance.Compute(cornersOf(i), mostQueries, largest, &last.Nearby); // often its neighbor
    largest = std::max(largest, last.Upper);
  }
  return largest;
}

/** Decimates a surface once per target. Returns an empty string, or an error. */
std::string Decimate(Decimator& decimator, const FaceDistance<3>& fromM,
  const DecimationOptions& options, int threads, const Progress& progress,
  std::vector<DecimatedSurface>& results)
{
  const SurfaceMesh& surface = decimator.GetSurface();
  const bool byError = options.Type == DecimationTarget::ErrorBound;
  const double all = std::log(static_cast<double>(surface.number_of_vertices()));
  const double own = options.Bounds.empty() ? 0.0 : MeasureError(AsTriangleMesh(surface), fromM);
  const auto policy = threads > 1 ? std::launch::async : std::launch::deferred;
  std::future<double> error; // of the last result, measured while the next one is made
  const auto finish = [&]
  {
    if (error.valid())
    {
      DecimatedSurface& result = results.back();
      result.Error = error.get();
      result.Reached =
        byError ? result.Error <= options.Targets[results.size() - 1] : result.Reached;
    }
  };
  for (std::size_t i = 0; i < options.Targets.size(); ++i)
  {
    const double target = options.Targets[i];
    bool stopped = false, hopeless = false;
    Hope hope(target);
    long long calls = 0;
    const auto mayGoOn = [&]
    {
      const double done = 1.0 - std::log(static_cast<double>(surface.number_of_vertices())) / all;
      stopped = ++calls % 1024 == 0 && !GoOn(progress, done);
      return !stopped;
    };
    const auto count = [&]() -> double
    {
      return options.Type == DecimationTarget::Triangles ? surface.number_of_faces()
                                                         : surface.number_of_vertices();
    };
    BoundSearch search(options.Bounds.empty() ? HUGE_VAL : options.Bounds[i], own);
    // The measured error may be 1 % too large; it has to be within the bound, too.
    std::optional<double> bound = byError ? target / 1.01 : search.First();
    bool reached = false;
    while (bound && !reached && !stopped)
    {
      decimator.RaiseErrorBound(*bound);
      const bool isBounded = std::isfinite(decimator.GetErrorBound());
      const auto goesOn = [&]
      {
        hopeless =
          options.GivesUp && !isBounded && decimator.TriesAllPositions() && !hope.GoesOn(count());
        return mayGoOn() && !hopeless && (byError || count() > target);
      };
      const auto triesHarder = [&]
      {
        if (byError)
        {
          return count() <= MostToTryHarder;
        }
        const double most =
          isBounded && *bound < options.Bounds[i] ? MostAboveTarget : MostAboveTargetAtLast;
        return !isBounded || count() <= most * target;
      };
      reached = decimator.Run(goesOn, triesHarder) && !hopeless;
      bound = byError || reached ? std::nullopt
                                 : search.Next(decimator.GetErrorBound(), count() / target);
    }
    // Bounds are below the distance of a known result, which is better than one that misses a number.
    const bool isOfUse = reached || options.Bounds.empty();
    for (int round = 0; round < TighteningRounds && isOfUse && !stopped; ++round)
    {
      decimator.Tighten(mayGoOn);
    }
    if (stopped)
    {
      return "stopped";
    }
    finish();
    results.push_back({ decimator.GetNumberOfCollapses(), reached, 0.0 });
    error = std::async(
      policy, [&fromM, copy = AsTriangleMesh(surface)] { return MeasureError(copy, fromM); });
    if (threads <= 1)
    {
      finish();
    }
  }
  finish();
  return {};
}

} // namespace

std::string DecimateEnclosing(const TriangleMesh& given, const TriangleMesh& mesh,
  const TriangleMesh& parts, const DecimationOptions& options, Decimation& result,
  const Progress& progress, int threads)
{
  ResolvedMesh original;
  std::string mistake = Prepare(given, original);
  if (!mistake.empty())
  {
    return mistake;
  }
  const bool isOfUser = &given == &mesh; // and no level of a stream
  if (isOfUser)
  {
    TurnPartsOutward(original);
  }
  std::optional<ChainRecorder> history; // the chain is made when all else has been released
  {
    const ResolvedMesh cleaned = Clean(AsResolved(mesh));
    if (cleaned.Facets.empty())
    {
      return "The surface has no triangle with an area.";
    }
    const FaceDistance<3> fromM(cleaned);
    const ResolvedMesh divided = parts.Triangles.empty() ? ResolvedMesh() : JoinMeshes(mesh, parts);
    std::optional<FacetTree<3>> divisions;
    if (!divided.Facets.empty())
    {
      divisions.emplace(divided);
    }
    std::optional<FaceDistance<3>> fromGiven;
    if (!isOfUser)
    {
      fromGiven.emplace(original);
    }
    Decimator decimator(AsSurfaceMesh(original), divisions ? *divisions : fromM.GetTree(), fromM,
      fromGiven ? *fromGiven : fromM, options.Nested);
    mistake = Decimate(decimator, fromM, options, threads, progress, result.Surfaces);
    if (!mistake.empty())
    {
      return mistake;
    }
    history = std::move(decimator).TakeHistory();
  }
  HandOn(*std::move(history), original, result);
  GoOn(progress, 1.0);
  return {};
}

} // namespace carving::helper
