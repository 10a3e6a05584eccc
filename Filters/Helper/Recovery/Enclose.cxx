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

#include <algorithm>
#include <cfloat>
#include <future>
#include <iterator>
#include <numeric>

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
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    const int index = cell->info().Index;
    for (int f = 0; f < 4; ++f)
    {
      const int part = cell->info().PartOn(f);
      if (part < 0 || result.Constraints[index][f] >= 0)
      {
        continue;
      }
      const int facet = static_cast<int>(surface.Facets.size());
      const int parent = mesh.GetParts().GetParts()[part].Parent;
      const Triangle outward = result.OutwardFace(index, f);
      AppendFacet<3>(input, parent,
        FaceAlike(mesh.CornersOf(part), FaceOf(cell, f)) ? outward : Flipped<3>(outward), surface);
      result.Constraints[index][f] = facet;
      const Cell other = cell->neighbor(f);
      if (!mesh.GetDelaunay().is_infinite(other))
      {
        result.Constraints[other->info().Index][other->index(cell)] = facet;
      }
    }
  }
}

/** Whether more than one pair of triangles in a hundred triangles crosses. */
bool CrossesItselfOften(const ResolvedMesh& input)
{
  constexpr double often = 0.01; // per triangle
  const std::size_t crossings = FindIntersections(input.Points, input.Facets).size();
  return static_cast<double>(crossings) > often * static_cast<double>(input.Facets.size());
}

/**
 * Measures the share of M's area that is faces, which is returned, and that of each triangle's area.
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

} // namespace

Enclosure Enclose(const ResolvedMesh& input, const std::vector<Point>& further, double tolerance,
  int threads, const std::function<bool(double)>& progress, Tetrahedralization& result)
{
  const double length = Diagonal(input.Points);
  const SurfaceDistance distance(input);
  constexpr double negligible = 1e-4;
  constexpr double accuracy = 1.05; // distances are exact to within this factor
  const double bound = tolerance * length / accuracy;
  const bool mayAddPoints = tolerance > 0.0;
  // Where triangles cross each other, recovery meets few of them.
  const auto policy =
    threads > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
  std::future<bool> crossing =
    std::async(policy, [&] { return mayAddPoints && CrossesItselfOften(input); });
  PiercedMesh mesh(input, further, threads, PartOf(progress, 0.0, 0.1));
  const bool crosses = crossing.get();
  // Cutting takes less time than more steps would, but not where many triangles cross each other.
  const std::ptrdiff_t stepsPerFacet = crosses ? 100 : 30;
  const auto facets = static_cast<std::ptrdiff_t>(input.Facets.size());
  Recover(mesh, 100000 + stepsPerFacet * facets, PartOf(progress, 0.1, 0.2));
  if (mayAddPoints)
  {
    const std::size_t most = MaximumPointsAdded(input.Points.size());
    const std::vector<Subdivision::Part> needles = Cut(mesh, CutTolerance * length,
      { MaximumCuts, most, LeastYield }, threads, PartOf(progress, 0.2, 0.7));
    if (!crosses)
    {
      DetachAll(mesh, static_cast<int>(input.Points.size() + further.size()), 0);
    }
    mesh.GiveParts(needles, threads, PartOf(progress, 0.7, 0.7));
    HalveKept(mesh, distance, bound, most, threads, PartOf(progress, 0.7, 0.8));
    // Further points take the surface much closer than it has to be: to a quarter, and then to a
    // tenth. Their number is bounded by the size of the mesh.
    const std::size_t count = input.Points.size();
    std::size_t left =
      std::min(count / 10 + 10000 + std::min<std::size_t>(90000, 40 * count), most);
    left -= HalveKept(mesh, distance, 0.25 * bound, left, threads, PartOf(progress, 0.8, 0.85));
    HalveKept(mesh, distance, 0.1 * bound, left, threads, PartOf(progress, 0.85, 0.9));
  }
  KeepBareVertices(mesh, input);
  const KeptDistances kept = MeasureKept(mesh, distance, negligible * length, length, threads);
  result = {};
  result.Surface.PointSources = input.PointSources;
  WriteCells(mesh, result);
  result.Kept.resize(result.Cells.size());
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    result.Kept[cell->info().Index] = cell->info().IsPierced();
  }
  WriteFaces(mesh, input, result);
  result.Unresolved = input;
  result.MetShares.resize(input.Facets.size());
  return { kept, MeasureMetShares(mesh, result.MetShares) };
}

} // namespace carving::helper
