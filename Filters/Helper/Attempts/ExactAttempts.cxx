// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/ExactAttempts.h"

#include "Core/Mesh/Box.h"
#include "Core/Protocol/SecondsSince.h"
#include "Helper/Exact/InitialSurface.h"
#include "Helper/Exact/Tetrahedralize.h"
#include "Helper/Recovery/FlatParts.h"
#include "Helper/Recovery/NearDelaunay.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Interior.h"
#include "Helper/Resolve/Intersections.h"
#include "Helper/Resolve/Orient.h"
#include "Helper/Resolve/Resolve.h"
#include "Helper/Resolve/Snap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

namespace carving::helper
{
namespace
{

constexpr int NumberOfOrders = 2;
constexpr int NumberOfSnappedOrders = 3; ///< at each step
constexpr int NumberOfSteps = 3;         ///< ever finer ones
constexpr double StepRatio = 8.0;        ///< between one step and the next
/**
 * Auto does not resolve a mesh with more pairs of triangles that cross: TetGen would fail, or on
 * small meshes take longer than enclosing. Every crossing may be the one at which TetGen fails, so
 * that their number matters, but on large meshes crossings are farther apart. Of measured meshes
 * with fewer pairs, most came through; of large ones with more, none.
 */
double MaximumPairs(const Job& job, std::size_t numberOfFacets)
{
  const double facets = static_cast<double>(numberOfFacets);
  return job.Conformity == Conformity::Auto
    ? std::max(0.4 * facets, std::min(15000.0, 5000.0 + 2.0 * facets))
    : HUGE_VAL;
}

/** Resolves M and C0 together, so that they meet in common vertices and edges only. */
std::string AddInitial(const Job& job, ResolvedMesh& surface)
{
  // A triangle that is given twice must not be marked twice.
  ResolvedMesh initial = Clean(AsResolved(job.InitialMesh));
  OrientAlike(initial);
  std::string mistake = CheckInitialSurface(initial);
  mistake = mistake.empty() ? CheckPointsWithin(initial, surface) : mistake;
  if (!mistake.empty())
  {
    return mistake;
  }
  AddInitialSurface(initial, surface);
  surface = Clean(surface);
  int pairs = 0; // between M and C0: the reply counts only those within M
  return Resolve(surface, pairs, {});
}

} // namespace

/** Resolving takes so long that all orders share the resolved mesh. */
bool ExactAttempts::TryExact()
{
  ResolvedMesh& surface = this->TheReply.Result.Surface;
  std::vector<std::pair<int, int>> pairs;
  // Without a report: the progress is that of the attempt that runs meanwhile.
  const auto findMeanwhile = [&]
  {
    const auto start = std::chrono::steady_clock::now();
    pairs = FindIntersections(surface.Points, surface.Facets);
    this->TheReply.StageSeconds[static_cast<int>(Stage::Resolve)] += SecondsSince(start);
    return pairs.empty();
  };
  // Few meshes cross themselves. So the search need not come first if a processor is free.
  const bool early = this->TheJob.Processes > 1 && !this->IsCustom && !this->IsRecovery;
  if (early && this->TryFirst(findMeanwhile))
  {
    return true;
  }
  const bool hasTried = early && pairs.empty();
  this->Host.Begin(Stage::Resolve);
  if (!early)
  {
    pairs = FindIntersections(surface.Points, surface.Facets);
  }
  this->TheReply.IntersectingPairs = static_cast<int>(pairs.size());
  const std::string mistake = ResolvePairs(surface, std::move(pairs), this->Host.Report,
    MaximumPairs(this->TheJob, surface.Facets.size()));
  this->Host.End();
  if (!mistake.empty())
  {
    this->Failures.Add("Resolving: ", { mistake });
    return false;
  }
  this->Resolved.Add("yes");
  if (this->IsCustom)
  {
    this->TheReply.Error = AddInitial(this->TheJob, surface);
    if (!this->TheReply.Error.empty())
    {
      return this->WriteError();
    }
  }
  if (this->IsRecovery)
  {
    return this->TryRecovery(RecoveryEffort::Much);
  }
  if (!hasTried && this->TryFirst())
  {
    return true;
  }
  const auto tryRecovery = [this]
  { return this->MayRecover() && this->TryRecovery(RecoveryEffort::Much); };
  // Where TetGen ended by itself but lost triangles, another order mostly loses none.
  const bool recoverFirst = !this->HasFinished;
  return (recoverFirst && tryRecovery()) ||
    this->TryOrders("TetGen -pcY", 1, NumberOfOrders, SurfacePoints::None) ||
    (!recoverFirst && tryRecovery()) || this->TryWithoutInterior() ||
    this->TryOrders("TetGen -pc", 0, NumberOfOrders, SurfacePoints::Allowed);
}

/** Recovery leaves too many triangles of a mesh whose crossings have been resolved. */
bool ExactAttempts::MayRecover() const
{
  return this->TheJob.Strategy == Strategy::Auto && this->TheReply.IntersectingPairs == 0;
}

/**
 * Tries the fastest attempts. If `isResolved`, which is called meanwhile, returns false, they leave
 * no trace.
 */
bool ExactAttempts::TryFirst(const std::function<bool()>& isResolved)
{
  bool resolved = true;
  std::function<bool()> meanwhile;
  if (isResolved)
  {
    meanwhile = [&] { return resolved = isResolved(); };
  }
  const auto start = std::chrono::steady_clock::now();
  const bool isNear = this->MayRecover() && IsNearDelaunay(this->TheReply.Result.Surface);
  this->TheReply.StageSeconds[static_cast<int>(Stage::Tetrahedralize)] += SecondsSince(start);
  if (isNear)
  {
    if (this->TryRecovery(RecoveryEffort::Little, meanwhile))
    {
      return true;
    }
    this->Failures.Clear(); // it took little time, and users need not know of it
    meanwhile = {};
  }
  if (resolved && this->TryOrder("TetGen -pcY", 0, SurfacePoints::None, meanwhile))
  {
    return true;
  }
  if (!resolved)
  {
    this->TheReply.Strategy.clear();
    this->Failures.Clear();
  }
  return false;
}

/**
 * Tries M with other triangles in flat parts, with parts joined that touch but for rounding, and
 * with all points rounded.
 */
bool ExactAttempts::TrySnapped()
{
  const ResolvedMesh given = std::move(this->TheReply.Result.Surface);
  const double tolerance = this->TheJob.SnapTolerance * Diagonal(given.Points);
  const auto attempt = [&](double coarsest, Snapping* snap, const std::string& what)
  { return this->TrySnapped(given, tolerance, coarsest, snap, what); };
  const auto join = [&]
  { return attempt(tolerance / 4.0, SnapTouching, "Joining what touches within "); };
  const auto round = [&]
  { return attempt(GridSpacing(tolerance), Snap, "Snapping on a grid of "); };
  // Where exact resolving has come to its end, parts seldom touch but for rounding.
  return this->Resolved.Get().empty()
    ? join() || round()
    : this->TryDelaunayFaces(given, tolerance) || round() || join();
}

/** Tries the resolved M with flat parts triangulated as in the Delaunay tetrahedralization. */
bool ExactAttempts::TryDelaunayFaces(const ResolvedMesh& given, double tolerance)
{
  if (this->TheJob.Strategy == Strategy::TetGen)
  {
    return false;
  }
  this->Host.Begin(Stage::Resolve);
  ResolvedMesh& surface = this->TheReply.Result.Surface;
  surface = given;
  const std::string mistake = Resolve(surface, this->TheReply.IntersectingPairs, this->Host.Report);
  RetriangulatedMesh adopted;
  if (mistake.empty())
  {
    adopted = AdoptDelaunayFaces(surface, this->FurtherPoints(surface.Points), tolerance);
  }
  this->Host.End();
  if (adopted.Changed == 0)
  {
    return false;
  }
  surface = std::move(adopted.Mesh);
  this->TheReply.SnapDistance = adopted.Distance;
  return this->TryRecovery(RecoveryEffort::Little) || // more would leave no time for other ways
    (this->TheJob.Strategy == Strategy::Auto &&
      this->TryOrder("TetGen -pcY, snapped", 0, SurfacePoints::None));
}

/** Tries ever finer steps of one way to move points. */
bool ExactAttempts::TrySnapped(const ResolvedMesh& given, double tolerance, double coarsest,
  Snapping* snap, const std::string& what)
{
  const double maximumPairs = MaximumPairs(this->TheJob, given.Facets.size());
  double step = coarsest;
  SnappedMesh snapped;
  // Where too many pairs cross each other, hardly fewer do so after finer steps.
  for (int i = 0; i < NumberOfSteps && snapped.IntersectingPairs <= maximumPairs; ++i)
  {
    this->TheReply.Strategy.clear(); // or progress would name the last attempt on the coarser step
    this->Host.Begin(Stage::Resolve);
    std::string mistake = snap(given, step, this->Host.Report, maximumPairs, snapped);
    this->Host.End();
    mistake = mistake.empty() ? this->CheckSnapped(snapped, tolerance) : mistake;
    if (!mistake.empty())
    {
      std::ostringstream text;
      text << what << step << ": " << mistake;
      this->Failures.Add("", { text.str() });
    }
    else if (this->TryMoved(snapped))
    {
      return true;
    }
    step /= StepRatio;
  }
  return false;
}

/** Why a snapped mesh is not worth an attempt, or an empty string. */
std::string ExactAttempts::CheckSnapped(const SnappedMesh& snapped, double tolerance) const
{
  if (snapped.Distance > tolerance)
  {
    return "points move farther than SnapTolerance";
  }
  return snapped.Distance == 0.0
    ? "no point moves"
    : CheckVolume(snapped.Mesh, this->FurtherPoints(snapped.Mesh.Points));
}

bool ExactAttempts::TryMoved(SnappedMesh& snapped)
{
  this->TheReply.Result.Surface = std::move(snapped.Mesh);
  this->TheReply.IntersectingPairs = snapped.IntersectingPairs;
  this->TheReply.SnapDistance = snapped.Distance;
  return this->IsRecovery
    ? this->TryRecovery(RecoveryEffort::Much)
    : this->TryOrders("TetGen -pcY, snapped", 0, NumberOfSnappedOrders, SurfacePoints::None) ||
      this->TryOrders("TetGen -pc, snapped", 0, 1, SurfacePoints::Allowed);
}

/** Tries the boundary of the solid alone, in all orders. On failure M is as it was. */
bool ExactAttempts::TryWithoutInterior()
{
  this->TheReply.SolidMatters = 1;
  if (this->IsCustom) // the triangles of C0 do not bound a solid
  {
    return false;
  }
  const ResolvedMesh whole = this->TheReply.Result.Surface;
  this->TheReply.InteriorDropped = DropInterior(this->TheJob.Solid, this->TheReply.Result.Surface);
  if (this->TheReply.InteriorDropped > 0 &&
    this->TryOrders("TetGen -pcY, without interior", 0, NumberOfOrders, SurfacePoints::None))
  {
    return true;
  }
  this->TheReply.Result.Surface = whole;
  this->TheReply.InteriorDropped = 0;
  return false;
}

} // namespace carving::helper
