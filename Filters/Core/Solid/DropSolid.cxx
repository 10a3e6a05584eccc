// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/DropSolid.h"

#include <utility>

namespace carving
{
namespace
{

/** Notes the region of a tetrahedron of the solid at the facets of M on its boundary. */
void NoteFacets(const Tetrahedralization& mesh, int cell, Classification& regions)
{
  for (int f = 0; f < 4; ++f)
  {
    const int facet = mesh.Constraints.Get(cell, f);
    if (facet >= 0)
    {
      regions.SolidRegions[facet][SideOfFacet(mesh, cell, f)] = regions.RegionOfCell[cell];
    }
  }
}

} // namespace

void DropSolid(Tetrahedralization& mesh, Classification& regions)
{
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  regions.SolidRegions.assign(mesh.Surface.Facets.size(), { -1, -1 });
  std::vector<int> newIndex(numberOfCells, Solid);
  FaceConstraints<3> constraints;
  int stored = 0;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    if (regions.Kind(cell) == RegionKind::Solid)
    {
      NoteFacets(mesh, cell, regions);
      continue;
    }
    newIndex[cell] = stored;
    mesh.Cells[stored] = mesh.Cells[cell];
    mesh.Neighbors[stored] = mesh.Neighbors[cell];
    constraints.Append(mesh.Constraints.Get(cell));
    regions.RegionOfCell[stored] = regions.RegionOfCell[cell];
    ++stored;
  }
  const auto resize = [stored](auto&... arrays) { (arrays.resize(stored), ...); };
  resize(mesh.Cells, mesh.Neighbors, regions.RegionOfCell);
  mesh.Constraints = std::move(constraints);
  for (auto& neighbors : mesh.Neighbors)
  {
    for (int& neighbor : neighbors)
    {
      neighbor = neighbor < 0 ? neighbor : newIndex[neighbor];
    }
  }
}

} // namespace carving
