// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/Enclose.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Base/Effort.h"
#include "Helper/Enclosing/Refine.h"

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;

void WriteCells(const PiercedMesh& mesh, Tetrahedralization& result)
{
  const PiercedMesh::Delaunay& delaunay = mesh.GetDelaunay();
  int count = 0;
  for (const Cell cell : delaunay.finite_cell_handles())
  {
    cell->info().Index = count++;
  }
  for (const Cell cell : delaunay.finite_cell_handles())
  {
    auto& corners = result.Cells.emplace_back();
    auto& neighbors = result.Neighbors.emplace_back();
    result.Constraints.push_back({ -1, -1, -1, -1 });
    for (int i = 0; i < 4; ++i)
    {
      const Cell other = cell->neighbor(i);
      corners[i] = cell->vertex(i)->info().Index;
      neighbors[i] = delaunay.is_infinite(other) ? Outside : other->info().Index;
    }
    result.Kept.push_back(cell->info().IsPierced());
  }
}

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

} // namespace

double Enclose(const ResolvedMesh& input, const std::vector<Point>& further, double tolerance,
  const std::function<bool(double)>& progress, Tetrahedralization& result)
{
  PiercedMesh mesh(input, further, [&](double done) { return progress(done / 2.0); });
  const double diagonal = Diagonal(input.Points);
  const SurfaceDistance distance(input);
  if (tolerance > 0.0)
  {
    constexpr double Accuracy = 1.05; // distances are exact to within this factor
    Refine(mesh, distance, tolerance * diagonal / Accuracy, MaximumPointsAdded(input.Points.size()),
      [&](double done) { return progress((1.0 + done) / 2.0); });
  }
  result = {};
  result.Surface.Points = mesh.GetParts().GetPoints();
  result.Surface.PointSources = input.PointSources;
  result.Surface.PointSources.resize(result.Surface.Points.size(), -1);
  WriteCells(mesh, result);
  WriteFaces(mesh, input, result);
  result.Unresolved = input;
  constexpr double Negligible = 1e-4;
  return Reach(mesh, distance, Negligible * diagonal);
}

} // namespace carving::helper
