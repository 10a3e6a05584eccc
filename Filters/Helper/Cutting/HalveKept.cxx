// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Cutting/HalveKept.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/ExposedFaces.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Edge = std::array<int, 2>;

/** Whether a pierced cell has a face that reaches too far; faces that do not are remembered. */
bool ReachesTooFar(
  const PiercedMesh& mesh, const Cell& cell, const SurfaceDistance& distance, double tolerance)
{
  CellContacts& info = cell->info();
  for (int f = 0; f < 4; ++f)
  {
    if (info.Near[f] || !IsExposed(mesh, cell, f))
    {
      continue;
    }
    info.Near[f] =
      LongestEdge(cell) <= tolerance || distance.IsWithin(FacePoints(cell, f), tolerance);
    if (!info.Near[f])
    {
      return true;
    }
  }
  return false;
}

/** An edge and its squared length. Ties are broken by the indices of the ends. */
using Measured = std::pair<double, Edge>;

Measured FindLongestEdge(const Cell& cell)
{
  Measured longest(-1.0, Edge{});
  for (int i = 0; i < 3; ++i)
  {
    for (int k = i + 1; k < 4; ++k)
    {
      const auto [lower, upper] =
        std::minmax({ cell->vertex(i)->info().Index, cell->vertex(k)->info().Index });
      const double length =
        CGAL::squared_distance(cell->vertex(i)->point(), cell->vertex(k)->point());
      longest = std::max(longest, Measured(length, Edge{ lower, upper }));
    }
  }
  return longest;
}

/**
 * From edge to longer edge, to one that is the longest in all cells around it. To halve others
 * would make cells ever thinner (Rivara's longest-edge propagation path).
 */
Edge FindTerminalEdge(const PiercedMesh& mesh, Measured edge)
{
  Measured longest = edge;
  do
  {
    edge = longest;
    for (const Cell& cell : mesh.FindCellsAround(edge.second[0], edge.second[1]))
    {
      if (!mesh.GetDelaunay().is_infinite(cell))
      {
        longest = std::max(longest, FindLongestEdge(cell));
      }
    }
  } while (longest != edge);
  return edge.second;
}

/** Rounding turns other cells over at other points of an edge. */
bool SplitNearMiddle(PiercedMesh& mesh, const Edge& edge)
{
  const auto [a, b] = edge;
  const std::vector<Point>& points = mesh.GetParts().GetPoints();
  const auto isProtected = [](int, int) { return false; };
  for (const double share : { 0.5, 0.45, 0.55, 0.4, 0.6 })
  {
    if (mesh.SplitEdge(a, b, Between(points[a], points[b], share), isProtected) >= 0)
    {
      return true;
    }
  }
  return false;
}

} // namespace

void HalveKept(PiercedMesh& mesh, const SurfaceDistance& distance, double tolerance,
  std::size_t maximumPoints, const std::function<bool(double)>& progress)
{
  constexpr int mostRounds = 100; // each looks at all tetrahedra
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    cell->info().Near = {};
  }
  std::size_t added = 0;
  for (int round = 0; round < mostRounds && added < maximumPoints; ++round)
  {
    progress(static_cast<double>(added) / static_cast<double>(maximumPoints));
    std::vector<Measured> edges;
    for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
    {
      if (cell->info().IsPierced() && ReachesTooFar(mesh, cell, distance, tolerance))
      {
        edges.push_back(FindLongestEdge(cell));
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::size_t split = 0;
    for (const Measured& edge : edges)
    {
      split += added + split < maximumPoints &&
        (SplitNearMiddle(mesh, FindTerminalEdge(mesh, edge)) || SplitNearMiddle(mesh, edge.second));
    }
    added += split;
    if (split == 0)
    {
      break;
    }
  }
}

} // namespace carving::helper
