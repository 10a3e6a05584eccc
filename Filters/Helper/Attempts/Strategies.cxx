// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Strategies.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Attempts/ChildProcess.h"
#include "Helper/Attempts/Log.h"
#include "Helper/Attempts/Patience.h"
#include "Helper/Attempts/Shuffle.h"
#include "Helper/Enclosing/Enclose.h"
#include "Helper/Exact/InitialSurface.h"
#include "Helper/Exact/Tetrahedralize.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Interior.h"
#include "Helper/Resolve/Resolve.h"
#include "Helper/Resolve/Snap.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

using namespace carving;

namespace
{

constexpr int NumberOfOrders = 6;
constexpr int NumberOfSplitOrders = 2;
constexpr int NumberOfOrdersBeforeDropping = 2;
constexpr int NumberOfSnappedOrders = 3;
constexpr int NumberOfGrids = 3;
constexpr double FinerGrid = 8.0; ///< each to the next
/** Auto does not resolve where there are so many crossings for a triangle. */
constexpr double TooManyCrossings = 2.0;

double MaximumPairs(const Job& job, std::size_t numberOfFacets)
{
  return job.Conformity == Conformity::Auto ? TooManyCrossings * static_cast<double>(numberOfFacets)
                                            : HUGE_VAL;
}

/** Resolves M and C0 together, so that they meet in common vertices and edges only. */
std::string AddInitial(const Job& job, ResolvedMesh& surface)
{
  const std::string mistake = CheckInitialSurface(job.InitialMesh);
  if (!mistake.empty())
  {
    return mistake;
  }
  AddInitialSurface(job.InitialMesh, surface);
  surface = Clean(surface);
  int pairs = 0; // of M with C0: not the input's
  return Resolve(surface, pairs, {});
}

std::vector<Point> FurtherPoints(const Job& job, const std::vector<Point>& points)
{
  return job.Initial == InitialApproximation::BoundingBox && !points.empty() ? GrownBox(points)
                                                                             : std::vector<Point>();
}

/** Runs an attempt apart and logs what has ended it, unless it has said so itself. */
bool Try(const std::string& attempt, const std::string& who, const Limits& limits, Log& log,
  const std::function<bool()>& work)
{
  const Ending ending = RunInChildProcess(limits, work);
  if (!ending.Mistake.empty() && ending.Mistake != "failed")
  {
    log.Add(attempt, { who + ending.Mistake, ending.ByLimit });
  }
  return ending.Mistake.empty();
}

bool HandOver(const Reply& reply, const StrategyHost& host, Log& log)
{
  host.End();
  const bool written = host.Write();
  if (!written)
  {
    log.Add(reply.Strategy + ": ", { "the result could not be written" });
  }
  return written;
}

/** One attempt, in a process of its own. */
bool Attempt(int order, SurfacePoints surfacePoints, const Job& job, Reply& reply,
  const StrategyHost& host, Log& log)
{
  Shuffle(order, reply.Result.Surface);
  const Ending ending =
    Tetrahedralize(FurtherPoints(job, reply.Result.Surface.Points), surfacePoints, reply.Result);
  if (!ending.Mistake.empty())
  {
    log.Add(reply.Strategy + ": ", ending);
    return false;
  }
  if (job.Initial == InitialApproximation::Custom)
  {
    reply.Error = RemoveOutsideOfInitial(reply.Result);
    if (!reply.Error.empty())
    {
      host.End();
      return host.Write(); // no other order would help
    }
  }
  log.CopyTo(reply);
  return HandOver(reply, host, log);
}

/** Tries orders, from the first until one before the last succeeds. */
bool TryOrders(const std::string& rung, int first, int last, SurfacePoints surfacePoints,
  const Job& job, Reply& reply, const StrategyHost& host, Log& log)
{
  const Limits limits = LimitsOfAttempt(job, surfacePoints, reply.Result.Surface.Facets.size());
  for (int order = first; order < last; ++order)
  {
    reply.Strategy = rung + (order == 0 ? "" : ", order " + std::to_string(order));
    if (Try(reply.Strategy + ": ", "TetGen ", limits, log,
          [&] { return Attempt(order, surfacePoints, job, reply, host, log); }))
    {
      return true;
    }
  }
  return false;
}

/** Tries all orders of what bounds the solid; leaves M as it was where that does not help. */
bool TryWithoutInterior(const Job& job, Reply& reply, const StrategyHost& host, Log& log)
{
  reply.SolidMatters = 1;
  if (job.Initial == InitialApproximation::Custom) // whose triangles are no boundary of a solid
  {
    return false;
  }
  const ResolvedMesh whole = reply.Result.Surface;
  reply.InteriorDropped = DropInterior(job.Solid, reply.Result.Surface);
  if (reply.InteriorDropped > 0 &&
    TryOrders("TetGen -pcY, without interior", 0, NumberOfOrders, SurfacePoints::None, job, reply,
      host, log))
  {
    return true;
  }
  reply.Result.Surface = whole;
  reply.InteriorDropped = 0;
  return false;
}

/** Resolves and tries all orders; in a process of its own too, so that its time can be limited. */
bool TryExact(const Job& job, Reply& reply, const StrategyHost& host, Log& log)
{
  host.Begin(Stage::Resolve);
  reply.Error = Resolve(reply.Result.Surface, reply.IntersectingPairs, host.Report,
    MaximumPairs(job, reply.Result.Surface.Facets.size()));
  if (!reply.Error.empty())
  {
    log.Add("Resolving: ", { reply.Error });
    return false;
  }
  if (job.Initial == InitialApproximation::Custom)
  {
    reply.Error = AddInitial(job, reply.Result.Surface);
    if (!reply.Error.empty())
    {
      host.End();
      return host.Write(); // the user's to mend
    }
  }
  host.End();
  host.Begin(Stage::Tetrahedralize);
  const auto tryOrders = [&](const char* rung, int first, int last, SurfacePoints surfacePoints)
  { return TryOrders(rung, first, last, surfacePoints, job, reply, host, log); };
  return tryOrders("TetGen -pcY", 0, NumberOfOrdersBeforeDropping, SurfacePoints::None) ||
    TryWithoutInterior(job, reply, host, log) ||
    tryOrders("TetGen -pcY", NumberOfOrdersBeforeDropping, NumberOfOrders, SurfacePoints::None) ||
    tryOrders("TetGen -pcM", 0, NumberOfSplitOrders, SurfacePoints::Allowed);
}

/** What is wrong with a snapped mesh, or an empty string. */
std::string CheckSnapped(const Job& job, const SnappedMesh& snapped, double tolerance)
{
  if (snapped.Distance > tolerance)
  {
    return "points move farther than SnapTolerance";
  }
  return snapped.Distance == 0.0
    ? "no point moves"
    : CheckVolume(snapped.Mesh, FurtherPoints(job, snapped.Mesh.Points));
}

/** Tries orders of M with its points moved, on ever finer grids. */
bool TrySnapped(const Job& job, Reply& reply, const StrategyHost& host, Log& log)
{
  const ResolvedMesh given = std::move(reply.Result.Surface);
  const double tolerance = job.SnapTolerance * Diagonal(given.Points);
  double spacing = GridSpacing(tolerance);
  for (int grid = 0; grid < NumberOfGrids; ++grid, spacing /= FinerGrid)
  {
    host.Begin(Stage::Resolve);
    SnappedMesh snapped;
    std::string mistake =
      Snap(given, spacing, host.Report, MaximumPairs(job, given.Facets.size()), snapped);
    host.End();
    mistake = mistake.empty() ? CheckSnapped(job, snapped, tolerance) : mistake;
    if (!mistake.empty())
    {
      std::ostringstream text;
      text << "Snapping: on a grid of " << spacing << ", " << mistake;
      log.Add("", { text.str() });
      continue;
    }
    reply.Result.Surface = std::move(snapped.Mesh);
    reply.IntersectingPairs = snapped.IntersectingPairs;
    reply.SnapDistance = snapped.Distance;
    host.Begin(Stage::Tetrahedralize);
    if (TryOrders("TetGen -pcY, snapped", 0, NumberOfSnappedOrders, SurfacePoints::None, job, reply,
          host, log))
    {
      return true;
    }
    host.End();
  }
  return false;
}

bool TryEnclosing(const Job& job, Reply& reply, const StrategyHost& host, Log& log)
{
  host.Begin(Stage::Tetrahedralize);
  const ResolvedMesh input = std::move(reply.Result.Surface);
  reply.Strategy = "Delaunay, enclosing";
  const std::vector<Point> further = FurtherPoints(job, input.Points);
  reply.KeptDistance = Enclose(input, further, job.EnclosingTolerance, host.Report, reply.Result);
  reply.PointsAdded =
    static_cast<int>(reply.Result.Surface.Points.size() - input.Points.size() - further.size());
  return HandOver(reply, host, log);
}

/** Lines as one. */
std::string Joined(std::string lines)
{
  while (!lines.empty() && lines.back() == '\n')
  {
    lines.pop_back();
  }
  std::replace(lines.begin(), lines.end(), '\n', ';');
  return lines + ".";
}

} // namespace

bool TryStrategies(const Job& job, Reply& reply, const StrategyHost& host)
{
  if (job.Initial != InitialApproximation::Custom)
  {
    const ResolvedMesh& surface = reply.Result.Surface;
    reply.Error = CheckVolume(surface, FurtherPoints(job, surface.Points));
    if (!reply.Error.empty())
    {
      return false;
    }
  }
  Log log;
  const std::size_t numberOfFacets = reply.Result.Surface.Facets.size();
  for (const auto& [climb, name, wanted] :
    { std::tuple(&TryExact, "Resolving and tetrahedralizing ", true),
      std::tuple(&TrySnapped, "Snapping ",
        job.SnapTolerance > 0.0 && job.Initial != InitialApproximation::Custom) })
  {
    if (!wanted || job.Conformity == Conformity::Enclosing)
    {
      continue;
    }
    if (Try("", name, LimitsOfExact(job, numberOfFacets), log,
          [&, climb = climb] { return (*climb)(job, reply, host, log); }))
    {
      return true;
    }
    reply.SolidMatters = 1;
  }
  log.CopyTo(reply);
  if (job.Conformity != Conformity::Exact && job.Initial != InitialApproximation::Custom)
  {
    const bool isEnclosed = Try("Delaunay, enclosing: ", "", LimitsOfEnclosing(job), log,
      [&] { return TryEnclosing(job, reply, host, log); });
    log.CopyTo(reply);
    reply.Error = isEnclosed
      ? ""
      : "The mesh could not even be enclosed. Raise TimeLimit or MemoryLimit if they are set. What "
        "was tried: " +
        Joined(reply.Attempts);
    return isEnclosed;
  }
  if (reply.Error.empty())
  {
    reply.Error = "TetGen does not cope with the mesh. Repair or leave out the parts that cross "
                  "themselves or nearly touch, let Conformity be AUTO, set SnapTolerance, or raise "
                  "TimeLimit or MemoryLimit if they are set. What was tried: " +
      Joined(reply.Attempts);
  }
  return false;
}
