// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/Enclose.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Progress.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/Effort.h"
#include "Helper/Cutting/Cut.h"
#include "Helper/Cutting/HalveKept.h"
#include "Helper/Enclosing/ExposedFaces.h"
#include "Helper/Recovery/Detach.h"
#include "Helper/Recovery/Recover.h"
#include "Helper/Recovery/WriteCells.h"
#include "Helper/Resolve/Intersections.h"
#include "Helper/Resolve/Resolve.h"

#include <algorithm>
#include <cfloat>
#include <future>
#include <iterator>
#include <memory>
#include <numeric>
#include <utility>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;

/** Changes that cutting may try: they take about eight seconds. */
constexpr std::size_t MaximumCuts = 1500000;
constexpr double LeastYield = 0.0025; ///< of M's area; 100,000 changes take half a second

/** Adds the faces on which parts of M lie. */
void WriteFaces(const PiercedMesh& mesh, const ResolvedMesh& input, Tetrahedralization& result)
{
  ResolvedMesh& surface = result.Surface;
  std::vector<std::array<int, 4>> constraints(result.Cells.size(), { -1, -1, -1, -1 });
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    const int index = cell->info().Index;
    for (int f = 0; f < 4; ++f)
    {
      const int part = cell->info().PartOn(f);
      if (part < 0 || constraints[index][f] >= 0)
      {
        continue;
      }
      const int facet = static_cast<int>(surface.Facets.size());
      const int parent = mesh.GetParts().GetParts()[part].Parent;
      const Triangle outward = result.OutwardFace(index, f);
      AppendFacet<3>(input, parent,
        FaceAlike(mesh.CornersOf(part), FaceOf(cell, f)) ? outward : Flipped<3>(outward), surface);
      constraints[index][f] = facet;
      const Cell other = cell->neighbor(f);
      if (!mesh.GetDelaunay().is_infinite(other))
      {
        constraints[other->info().Index][other->index(cell)] = facet;
      }
    }
  }
  result.Constraints = FaceConstraints<3>(constraints);
}

/**
 * Measures the share of M's area that is faces, which is returned, and that of each triangle's
 * area.
 */
double MeasureMetShares(const PiercedMesh& mesh, std::vector<double>& shares)
{
  const auto& parts = mesh.GetParts().GetParts();
  std::vector<char> isFace(parts.size(), 1);
  for (const int part : mesh.FindMissing())
  {
    isFace[part] = 0;
  }
  std::vector<double> met(shares.size(), 0.0), all(shares.size(), 0.0);
  for (int part = 0; part < static_cast<int>(parts.size()); ++part)
  {
    const int parent = parts[part].Parent;
    if (parent >= 0)
    {
      // A part without area after rounding has a share nevertheless.
      const double area = std::max(mesh.GetParts().AreaOf(parts[part].Corners), DBL_MIN);
      all[parent] += area;
      met[parent] += isFace[part] ? area : 0.0;
    }
  }
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    shares[i] = all[i] > 0.0 ? met[i] / all[i] : 1.0; // rounding may leave no part of a triangle
  }
  return std::accumulate(met.begin(), met.end(), 0.0) /
    std::accumulate(all.begin(), all.end(), 0.0);
}

/**
 * Keeps a small tetrahedron at every vertex of M that is a corner of no part: cutting may leave out
 * the tip of a triangle whose sides both go through a vertex very close to it.
 */
void KeepBareVertices(PiercedMesh& mesh, const ResolvedMesh& input)
{
  const auto& parts = mesh.GetParts().GetParts();
  std::vector<char> isCorner(input.Points.size(), 0);
  std::vector<int> partOf(input.Facets.size(), -1);
  for (int part = 0; part < static_cast<int>(parts.size()); ++part)
  {
    const auto& [corners, parent] = parts[part];
    for (const int corner : corners)
    {
      if (parent >= 0 && corner < static_cast<int>(isCorner.size()))
      {
        isCorner[corner] = 1;
      }
    }
    if (parent >= 0)
    {
      partOf[parent] = part;
    }
  }
  for (std::size_t t = 0; t < input.Facets.size(); ++t)
  {
    for (const int corner : input.Facets[t])
    {
      if (isCorner[corner] || partOf[t] < 0)
      {
        continue;
      }
      isCorner[corner] = 1;
      std::vector<Cell> star;
      mesh.GetDelaunay().finite_incident_cells(mesh.GetVertex(corner), std::back_inserter(star));
      const Cell smallest = *std::min_element(star.begin(), star.end(),
        [](const Cell& a, const Cell& b) { return LongestEdge(a) < LongestEdge(b); });
      smallest->info().Add({ partOf[t], { true, -1 } });
    }
  }
}

using Pairs = std::vector<std::pair<int, int>>;

/** Tetrahedra whose faces are as much of M as recovery and cutting reach. */
struct CutTetrahedra
{
  CutTetrahedra(const ResolvedMesh& input, const std::vector<Point>& further, int threads,
    const Progress& progress)
    : Input(input)
    , Mesh(Input, further, threads, progress)
  {
  }

  ResolvedMesh Input;
  PiercedMesh Mesh;
  std::vector<Subdivision::Part> Needles; ///< that the mesh lacks
  bool Crosses = false;                   ///< the input crosses itself often
  int ResolvedPairs = 0;                  ///< see Enclosure
};

/** Recovers and cuts; with `tolerance` 0, only recovers. */
void MeetParts(
  const Pairs& pairs, double tolerance, int threads, const Progress& progress, CutTetrahedra& cells)
{
  constexpr double often = 0.01; // per triangle
  const auto facets = static_cast<std::ptrdiff_t>(cells.Input.Facets.size());
  cells.Crosses = static_cast<double>(pairs.size()) > often * static_cast<double>(facets);
  // Cutting takes less time than more steps would, but not where many triangles cross each other.
  const std::ptrdiff_t stepsPerFacet = cells.Crosses ? 100 : 30;
  Recover(cells.Mesh, 100000 + stepsPerFacet * facets, PartOf(progress, 0.0, 0.2));
  if (tolerance > 0.0)
  {
    cells.Needles = Cut(cells.Mesh, tolerance,
      { MaximumCuts, MaximumPointsAdded(cells.Input.Points.size()), LeastYield }, threads,
      PartOf(progress, 0.2, 1.0));
  }
}

std::size_t CountKept(const PiercedMesh& mesh)
{
  const auto cells = mesh.GetDelaunay().finite_cell_handles();
  return std::count_if(
    cells.begin(), cells.end(), [](const Cell cell) { return cell->info().IsPierced(); });
}

/** The share of M's area that is faces. Needles do not count: most have hardly any area. */
double MetShareOf(const CutTetrahedra& cells)
{
  std::vector<double> shares(cells.Input.Facets.size());
  return MeasureMetShares(cells.Mesh, shares);
}

/**
 * Whether more of M is likely to be met if it is resolved first. With few crossings, little would
 * be gained. Where cutting leaves many tetrahedra pierced, more time would be lost than area
 * gained.
 */
bool MayMeetMoreResolved(const CutTetrahedra& cells, std::size_t pairs)
{
  constexpr std::size_t mostPairs = 20000;   // they are resolved in about two seconds
  constexpr std::size_t mostFacets = 400000; // two tetrahedralizations need memory
  constexpr double mostKept = 0.1;           // per triangle
  const std::size_t facets = cells.Input.Facets.size();
  return cells.Crosses && pairs <= std::min(facets, mostPairs) && facets <= mostFacets &&
    static_cast<double>(CountKept(cells.Mesh)) <= mostKept * static_cast<double>(facets);
}

/** Cuts M or, if more of it is met then, the resolved M. With `tolerance` 0, only recovers. */
std::unique_ptr<CutTetrahedra> CutBest(const ResolvedMesh& input, const std::vector<Point>& further,
  double tolerance, int threads, const Progress& progress)
{
  const auto policy =
    threads > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
  std::future<Pairs> search = std::async(policy,
    [&] { return tolerance > 0.0 ? FindIntersections(input.Points, input.Facets) : Pairs(); });
  auto cells = std::make_unique<CutTetrahedra>(input, further, threads, PartOf(progress, 0.0, 0.1));
  Pairs pairs = search.get();
  MeetParts(pairs, tolerance, threads, PartOf(progress, 0.1, 0.7), *cells);
  if (!MayMeetMoreResolved(*cells, pairs.size()))
  {
    return cells;
  }
  const int count = static_cast<int>(pairs.size());
  ResolvedMesh resolved = input;
  if (!ResolvePairs(resolved, std::move(pairs), {}).empty())
  {
    return cells;
  }
  auto others =
    std::make_unique<CutTetrahedra>(resolved, further, threads, PartOf(progress, 0.7, 0.8));
  MeetParts({}, tolerance, threads, PartOf(progress, 0.8, 1.0), *others);
  others->ResolvedPairs = count;
  return MetShareOf(*others) > MetShareOf(*cells) ? std::move(others) : std::move(cells);
}

} // namespace

Enclosure Enclose(const ResolvedMesh& input, const std::vector<Point>& further, double tolerance,
  int threads, const std::function<bool(double)>& progress, Tetrahedralization& result)
{
  const double length = Diagonal(input.Points);
  const bool mayAddPoints = tolerance > 0.0;
  const std::unique_ptr<CutTetrahedra> cells = CutBest(input, further,
    mayAddPoints ? CutTolerance * length : 0.0, threads, PartOf(progress, 0.0, 0.7));
  PiercedMesh& mesh = cells->Mesh;
  ResolvedMesh& met = cells->Input;
  constexpr double negligible = 1e-4;
  constexpr double accuracy = 1.05; // distances are exact to within this factor
  const double bound = tolerance * length / accuracy;
  const SurfaceDistance distance(met);
  if (mayAddPoints)
  {
    const std::size_t count = met.Points.size(), most = MaximumPointsAdded(count);
    // Detaching vertices at crossings would take most of the time.
    if (!cells->Crosses && cells->ResolvedPairs == 0)
    {
      DetachAll(mesh, static_cast<int>(count + further.size()), 0);
    }
    mesh.GiveParts(cells->Needles, threads, PartOf(progress, 0.7, 0.7));
    HalveKept(mesh, distance, bound, most, threads, PartOf(progress, 0.7, 0.8));
    // Further points take the surface much closer than it has to be: to a quarter, and then to a
    // tenth. Their number is bounded by the size of the mesh.
    std::size_t left =
      std::min(count / 10 + 10000 + std::min<std::size_t>(90000, 40 * count), most);
    left -= HalveKept(mesh, distance, 0.25 * bound, left, threads, PartOf(progress, 0.8, 0.85));
    HalveKept(mesh, distance, 0.1 * bound, left, threads, PartOf(progress, 0.85, 0.9));
  }
  KeepBareVertices(mesh, met);
  const KeptDistances kept = MeasureKept(mesh, distance, negligible * length, length, threads);
  mesh.PierceBelowNeedles(); // not measured: most of these tetrahedra are in the solid
  result = {};
  result.Surface.PointSources = met.PointSources;
  WriteCells(mesh, result);
  result.Kept.resize(result.Cells.size());
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    result.Kept[cell->info().Index] = cell->info().IsPierced();
  }
  WriteFaces(mesh, met, result);
  result.MetShares.resize(met.Facets.size());
  const double share = MeasureMetShares(mesh, result.MetShares);
  result.Unresolved = std::move(met);
  return { kept, share, cells->ResolvedPairs };
}

} // namespace carving::helper
