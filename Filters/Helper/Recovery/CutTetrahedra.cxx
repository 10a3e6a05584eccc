// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/CutTetrahedra.h"

#include "Helper/Base/Effort.h"
#include "Helper/Cutting/Cut.h"
#include "Helper/Recovery/DelaunayFaces.h"
#include "Helper/Recovery/Recover.h"
#include "Helper/Resolve/Intersections.h"
#include "Helper/Resolve/Resolve.h"

#include <algorithm>
#include <cfloat>
#include <future>
#include <numeric>
#include <utility>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Pairs = std::vector<std::pair<int, int>>;

/** Changes that cutting may try: they take some eight seconds. */
constexpr std::size_t MaximumCuts = 1450000;
constexpr double LeastYield = 0.0025; ///< of M's area; 100,000 changes take half a second

CutTetrahedra Tetrahedralize(
  ResolvedMesh input, const std::vector<Point>& further, int threads, const Progress& progress)
{
  CutTetrahedra result;
  result.Input = std::move(input);
  result.Mesh =
    std::make_unique<PiercedMesh>(PiercedMesh::Tetrahedralize(result.Input.Points, further),
      result.Input, further, threads, progress);
  return result;
}

/**
 * Gives flat parts of M of which triangles are missing the triangles that the tetrahedra have.
 * Nothing has been split before, so that each facet is one part.
 */
void AdoptFaces(double flatness, int threads, CutTetrahedra& cells)
{
  const std::vector<int> missing = cells.Mesh->FindMissing();
  std::vector<char> isMissing(cells.Input.Facets.size(), 0);
  for (const int part : missing)
  {
    isMissing[part] = 1;
  }
  RetriangulatedMesh adopted =
    AdoptFacesOf(cells.Mesh->GetDelaunay(), cells.Input, flatness, isMissing);
  if (adopted.Changed == 0)
  {
    return;
  }
  std::vector<int> replaced;
  std::vector<Subdivision::Part> given;
  for (int facet = 0; facet < static_cast<int>(isMissing.size()); ++facet)
  {
    if (adopted.Mesh.Facets[facet] != cells.Input.Facets[facet])
    {
      replaced.push_back(facet);
      given.push_back({ adopted.Mesh.Facets[facet], facet });
    }
  }
  cells.Mesh->TakeParts(replaced);
  cells.Mesh->GiveParts(given, threads, [](double) { return true; });
  cells.Input = std::move(adopted.Mesh);
  cells.FlatDistance = adopted.Distance;
}

/** Recovers, lets flat parts be, and cuts; with `tolerance` 0, does not cut. */
void MeetParts(const Pairs& pairs, double tolerance, double flatness, int threads,
  const Progress& progress, CutTetrahedra& cells)
{
  constexpr double often = 0.01; // per triangle
  const auto facets = static_cast<std::ptrdiff_t>(cells.Input.Facets.size());
  cells.Crosses = static_cast<double>(pairs.size()) > often * static_cast<double>(facets);
  // Cutting takes less time than more steps would, but not where many triangles cross each other.
  const std::ptrdiff_t stepsPerFacet = cells.Crosses ? 100 : 30;
  Recover(*cells.Mesh, 100000 + stepsPerFacet * facets, PartOf(progress, 0.0, 0.2));
  if (flatness > 0.0)
  {
    AdoptFaces(flatness, threads, cells);
  }
  if (tolerance > 0.0)
  {
    cells.Needles = Cut(*cells.Mesh, tolerance,
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
  return MeasureMetShares(*cells.Mesh, shares);
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
    static_cast<double>(CountKept(*cells.Mesh)) <= mostKept * static_cast<double>(facets);
}

} // namespace

CutTetrahedra CutBest(const ResolvedMesh& input, const std::vector<Point>& further,
  double tolerance, double flatness, int threads, const Progress& progress)
{
  const auto policy =
    threads > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
  std::future<Pairs> search = std::async(policy,
    [&] { return tolerance > 0.0 ? FindIntersections(input.Points, input.Facets) : Pairs(); });
  CutTetrahedra cells = Tetrahedralize(input, further, threads, PartOf(progress, 0.0, 0.1));
  Pairs pairs = search.get();
  MeetParts(pairs, tolerance, flatness, threads, PartOf(progress, 0.1, 0.7), cells);
  if (!MayMeetMoreResolved(cells, pairs.size()))
  {
    return cells;
  }
  const int count = static_cast<int>(pairs.size());
  ResolvedMesh resolved = input;
  if (!ResolvePairs(resolved, std::move(pairs), {}).empty())
  {
    return cells;
  }
  CutTetrahedra others =
    Tetrahedralize(std::move(resolved), further, threads, PartOf(progress, 0.7, 0.8));
  MeetParts({}, tolerance, flatness, threads, PartOf(progress, 0.8, 1.0), others);
  others.ResolvedPairs = count;
  return MetShareOf(others) > MetShareOf(cells) ? std::move(others) : std::move(cells);
}

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

} // namespace carving::helper
