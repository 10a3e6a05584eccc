// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Ladder.h"

#include "Apart.h"
#include "Clean.h"
#include "Enclose.h"
#include "InitialSurface.h"
#include "Interior.h"
#include "Priority.h"
#include "Resolve.h"
#include "Shuffle.h"
#include "Snap.h"
#include "Tetrahedralize.h"

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

/**
 * Time enough for any mesh that TetGen copes with: it takes milliseconds for a thousand triangles, a hundred
 * times that where it puts points on them, and for ever where it never ends to. Processor time, so that what
 * comes out does not depend on what else the machine has to do.
 */
double PatienceOfAttempt(const Job& job, SurfacePoints surfacePoints, std::size_t numberOfFacets)
{
  const double patience = surfacePoints == SurfacePoints::None
    ? 5.0 + 1e-4 * static_cast<double>(numberOfFacets)
    : 3.0 + 5e-4 * static_cast<double>(numberOfFacets);
  return job.Conformity == Conformity::Auto ? patience : 6.0 * patience;
}

Limits LimitsOfAttempt(const Job& job, SurfacePoints surfacePoints, std::size_t numberOfFacets)
{
  const bool isGiven = job.TimeLimit > 0.0;
  return { job.TimeLimit, job.MemoryLimit,
    isGiven ? 0.0 : PatienceOfAttempt(job, surfacePoints, numberOfFacets) };
}

/** For resolving and all attempts together. */
Limits LimitsOfExact(const Job& job, std::size_t numberOfFacets)
{
  const bool isAuto = job.Conformity == Conformity::Auto;
  return { 0.0, job.MemoryLimit,
    isAuto ? 50.0 + 1.5e-4 * static_cast<double>(numberOfFacets) : 0.0 };
}

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

bool HandOver(const Reply& reply, const LadderHost& host, Messages& messages)
{
  host.End();
  const bool written = host.Write();
  if (!written)
  {
    messages.Add(reply.Rung + ": the result could not be written");
  }
  return written;
}

/** One attempt, in a process of its own. */
bool Attempt(int order, SurfacePoints surfacePoints, const Job& job, Reply& reply,
  const LadderHost& host, Messages& messages)
{
  Shuffle(order, reply.Result.Surface);
  reply.Error =
    Tetrahedralize(FurtherPoints(job, reply.Result.Surface.Points), surfacePoints, reply.Result);
  if (reply.Error.empty() && job.Initial == InitialApproximation::Custom)
  {
    reply.Error = RemoveOutsideOfInitial(reply.Result);
    if (!reply.Error.empty())
    {
      host.End();
      return host.Write(); // no other order would help
    }
  }
  if (!reply.Error.empty())
  {
    messages.Add(reply.Rung + ": " + reply.Error);
    return false;
  }
  reply.Attempts = messages.Get();
  return HandOver(reply, host, messages);
}

/** Tries orders, from the first until one before the last succeeds. */
bool TryOrders(const std::string& rung, int first, int last, SurfacePoints surfacePoints,
  const Job& job, Reply& reply, const LadderHost& host, Messages& messages)
{
  const Limits limits = LimitsOfAttempt(job, surfacePoints, reply.Result.Surface.Facets.size());
  for (int order = first; order < last; ++order)
  {
    reply.Rung = rung + (order == 0 ? "" : ", order " + std::to_string(order));
    const std::string end =
      RunApart(limits, [&] { return Attempt(order, surfacePoints, job, reply, host, messages); });
    if (end.empty())
    {
      return true;
    }
    if (end != "failed") // which has said why
    {
      messages.Add(reply.Rung + ": TetGen " + end);
    }
  }
  return false;
}

/** Tries all orders of what bounds the solid; leaves M as it was where that does not help. */
bool TryWithoutInterior(const Job& job, Reply& reply, const LadderHost& host, Messages& messages)
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
      host, messages))
  {
    return true;
  }
  reply.Result.Surface = whole;
  reply.InteriorDropped = 0;
  return false;
}

/** Resolves and tries all orders; in a process of its own too, so that its time can be limited. */
bool ClimbExact(const Job& job, Reply& reply, const LadderHost& host, Messages& messages)
{
  host.Begin(Stage::Resolve);
  reply.Error = Resolve(reply.Result.Surface, reply.IntersectingPairs, host.Report,
    MaximumPairs(job, reply.Result.Surface.Facets.size()));
  if (!reply.Error.empty())
  {
    messages.Add("Resolving: " + reply.Error);
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
  { return TryOrders(rung, first, last, surfacePoints, job, reply, host, messages); };
  return tryOrders("TetGen -pcY", 0, NumberOfOrdersBeforeDropping, SurfacePoints::None) ||
    TryWithoutInterior(job, reply, host, messages) ||
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
bool ClimbSnapped(const Job& job, Reply& reply, const LadderHost& host, Messages& messages)
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
      messages.Add(text.str());
      continue;
    }
    reply.Result.Surface = std::move(snapped.Mesh);
    reply.IntersectingPairs = snapped.IntersectingPairs;
    reply.SnapDistance = snapped.Distance;
    host.Begin(Stage::Tetrahedralize);
    if (TryOrders("TetGen -pcY, snapped", 0, NumberOfSnappedOrders, SurfacePoints::None, job, reply,
          host, messages))
    {
      return true;
    }
    host.End();
  }
  return false;
}

bool ClimbEnclosing(const Job& job, Reply& reply, const LadderHost& host, Messages& messages)
{
  host.Begin(Stage::Tetrahedralize);
  const ResolvedMesh input = std::move(reply.Result.Surface);
  reply.Rung = "Delaunay, enclosing";
  const std::vector<Point> further = FurtherPoints(job, input.Points);
  reply.KeptDistance = Enclose(input, further, job.EnclosingTolerance, host.Report, reply.Result);
  reply.PointsAdded =
    static_cast<int>(reply.Result.Surface.Points.size() - input.Points.size() - further.size());
  return HandOver(reply, host, messages);
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

bool ClimbLadder(const Job& job, Reply& reply, const LadderHost& host)
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
  Messages messages;
  const std::size_t numberOfFacets = reply.Result.Surface.Facets.size();
  for (const auto& [climb, name, wanted] :
    { std::tuple(&ClimbExact, "Resolving and tetrahedralizing: ", true),
      std::tuple(&ClimbSnapped,
        "Snapping: ", job.SnapTolerance > 0.0 && job.Initial != InitialApproximation::Custom) })
  {
    if (!wanted || job.Conformity == Conformity::Enclosing)
    {
      continue;
    }
    const Limits limits = LimitsOfExact(job, numberOfFacets);
    const std::string end =
      RunApart(limits, [&, climb = climb] { return (*climb)(job, reply, host, messages); });
    if (end.empty())
    {
      return true;
    }
    if (end != "failed")
    {
      messages.Add(name + end);
    }
    reply.SolidMatters = 1;
  }
  reply.Attempts = messages.Get();
  if (job.Conformity != Conformity::Exact && job.Initial != InitialApproximation::Custom)
  {
    const Limits limits = { job.TimeLimit, job.MemoryLimit, 0.0 };
    const std::string end =
      RunApart(limits, [&] { return ClimbEnclosing(job, reply, host, messages); });
    if (end != "" && end != "failed") // which has said why
    {
      messages.Add("Delaunay, enclosing: " + end);
    }
    reply.Error = end.empty()
      ? ""
      : "The mesh could not even be enclosed. Raise TimeLimit or MemoryLimit if they are set. What "
        "was tried: " +
        Joined(messages.Get());
    return end.empty();
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
