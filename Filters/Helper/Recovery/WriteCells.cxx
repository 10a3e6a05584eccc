// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/WriteCells.h"

namespace carving::helper
{

void WriteCells(const PiercedMesh& mesh, Tetrahedralization& result)
{
  const PiercedMesh::Delaunay& delaunay = mesh.GetDelaunay();
  result.Surface.Points = mesh.GetParts().GetPoints();
  result.Surface.PointSources.resize(result.Surface.Points.size(), -1);
  int count = 0;
  for (const PiercedMesh::Cell cell : delaunay.finite_cell_handles())
  {
    cell->info().Index = count++;
  }
  result.Cells.reserve(count);
  result.Neighbors.reserve(count);
  result.Constraints.reserve(count);
  for (const PiercedMesh::Cell cell : delaunay.finite_cell_handles())
  {
    auto& corners = result.Cells.emplace_back();
    auto& neighbors = result.Neighbors.emplace_back();
    result.Constraints.push_back({ -1, -1, -1, -1 });
    for (int i = 0; i < 4; ++i)
    {
      const PiercedMesh::Cell other = cell->neighbor(i);
      corners[i] = cell->vertex(i)->info().Index;
      neighbors[i] = delaunay.is_infinite(other) ? Outside : other->info().Index;
    }
  }
}

} // namespace carving::helper
