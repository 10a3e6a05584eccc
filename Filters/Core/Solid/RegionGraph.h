// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which regions lie next to each other, and the largest cell of each.
 */
#ifndef carving_RegionGraph_h
#define carving_RegionGraph_h

#include "Core/Mesh/CellGeometry.h"
#include "Core/Solid/Classification.h"

#include <vector>

namespace carving
{

/** A way from one region into another, through a triangle of M. */
struct Crossing
{
  int Region;
  int Triangle;
  bool IntoBehind; ///< whether the region lies behind the triangle
};

/** The crossings out of each region. The last entry is that of the outside. */
template <int D>
std::vector<std::vector<Crossing>> FindCrossings(
  const Decomposition<D>& mesh, const Classification& result)
{
  const int outside = static_cast<int>(result.Regions.size());
  std::vector<std::vector<Crossing>> crossings(outside + 1);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      const int triangle = mesh.Constraints.Get(cell, f);
      if (triangle < 0)
      {
        continue;
      }
      const int neighbor = mesh.Neighbors[cell][f];
      const int to = result.RegionOfCell[cell];
      const int from = neighbor < 0 ? outside : result.RegionOfCell[neighbor];
      crossings[from].push_back({ to, triangle, SideOfFacet(mesh, cell, f) == 0 });
    }
  }
  return crossings;
}

/** The outside and all regions connected to it. */
inline std::vector<int> FindOutside(const Classification& result)
{
  std::vector<int> outside = { static_cast<int>(result.Regions.size()) };
  for (std::size_t region = 0; region < result.Regions.size(); ++region)
  {
    if (result.Regions[region].Kind == RegionKind::Outside)
    {
      outside.push_back(static_cast<int>(region));
    }
  }
  return outside;
}

/** The largest cell of each enclosed region. */
template <int D>
std::vector<int> FindLargestCells(const Decomposition<D>& mesh, const Classification& result)
{
  std::vector<int> largestCells(result.Regions.size(), -1);
  std::vector<double> largestSizes(result.Regions.size(), -1.0);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    if (result.Kind(cell) == RegionKind::Void)
    {
      const int region = result.RegionOfCell[cell];
      const double size = Size(CornersOfCell(mesh, cell));
      if (size > largestSizes[region])
      {
        largestSizes[region] = size;
        largestCells[region] = cell;
      }
    }
  }
  return largestCells;
}

} // namespace carving

#endif
