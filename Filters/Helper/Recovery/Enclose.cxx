// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/Enclose.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Progress.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/Effort.h"
#include "Helper/Cutting/Cut.h"
#include "Helper/Cutting/HalveKept.h"
#include "Helper/Enclosing/ExposedFaces.h"
#include "Helper/Recovery/CutTetrahedra.h"
#include "Helper/Recovery/Detach.h"
#include "Helper/Recovery/WriteCells.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;

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

Enclosure Enclose(const ResolvedMesh& input, const std::vector<Point>& further,
  const EnclosingTolerances& tolerances, int threads, const std::function<bool(double)>& progress,
  Tetrahedralization& result)
{
  const double length = Diagonal(input.Points);
  const bool mayAddPoints = tolerances.Distance > 0.0;
  CutTetrahedra cells = CutBest(input, further, mayAddPoints ? CutTolerance * length : 0.0,
    tolerances.Flatness * length, threads, PartOf(progress, 0.0, 0.7));
  PiercedMesh& mesh = *cells.Mesh;
  ResolvedMesh& met = cells.Input;
  constexpr double negligible = 1e-4;
  constexpr double accuracy = 1.05; // distances are exact to within this factor
  const double bound = tolerances.Distance * length / accuracy;
  const SurfaceDistance distance(met);
  if (mayAddPoints)
  {
    const std::size_t count = met.Points.size(), most = MaximumPointsAdded(count);
    // Detaching vertices at crossings would take most of the time.
    if (!cells.Crosses && cells.ResolvedPairs == 0)
    {
      DetachAll(mesh, static_cast<int>(count + further.size()), 0);
    }
    mesh.GiveParts(cells.Needles, threads, PartOf(progress, 0.7, 0.7));
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
  return { kept, share, cells.ResolvedPairs, cells.FlatDistance };
}

} // namespace carving::helper
