// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Cutting/HalveKept.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/ExposedFaces.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <vector>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Edge = std::array<int, 2>;

/** An edge, and a cell that has it as long as the mesh stays the same, from end to end. */
struct Measured
{
  double SquaredLength = -1.0;
  Edge Ends = {}; ///< break ties
  PiercedMesh::Delaunay::Edge Handle;

  friend bool operator<(const Measured& a, const Measured& b)
  {
    return std::tie(a.SquaredLength, a.Ends) < std::tie(b.SquaredLength, b.Ends);
  }
};

Measured FindLongestEdge(const Cell& cell)
{
  Measured longest;
  for (int i = 0; i < 3; ++i)
  {
    for (int k = i + 1; k < 4; ++k)
    {
      const int a = cell->vertex(i)->info().Index, b = cell->vertex(k)->info().Index;
      const double squaredLength =
        CGAL::squared_distance(cell->vertex(i)->point(), cell->vertex(k)->point());
      longest = std::max(longest,
        a < b ? Measured{ squaredLength, { a, b }, { cell, i, k } }
              : Measured{ squaredLength, { b, a }, { cell, k, i } });
    }
  }
  return longest;
}

/**
 * From edge to longer edge, to one that is the longest in all cells around it. To halve others
 * would make cells ever thinner (Rivara's longest-edge propagation path).
 */
Edge FindTerminalEdge(const PiercedMesh& mesh, const Measured& start)
{
  Measured longest = start;
  std::vector<Cell> cells = mesh.FindCellsAround(start.Ends[0], start.Ends[1], start.Handle);
  bool isLonger = !cells.empty();
  while (isLonger)
  {
    isLonger = false;
    for (const Cell& cell : cells)
    {
      const Measured edge =
        mesh.GetDelaunay().is_infinite(cell) ? Measured() : FindLongestEdge(cell);
      if (longest < edge)
      {
        longest = edge;
        isLonger = true;
      }
    }
    cells = isLonger ? mesh.FindCellsAround(longest.Handle) : cells;
  }
  return longest.Ends;
}

/** Rounding turns other cells over at other points of an edge. Returns the vertex; -1: none. */
int SplitNearMiddle(PiercedMesh& mesh, const Edge& edge)
{
  const auto [a, b] = edge;
  const std::vector<Point>& points = mesh.GetParts().GetPoints();
  const auto isProtected = [](int, int) { return false; };
  for (const double share : { 0.5, 0.45, 0.55, 0.4, 0.6 })
  {
    const int vertex = mesh.SplitEdge(a, b, Between(points[a], points[b], share), isProtected);
    if (vertex >= 0)
    {
      return vertex;
    }
  }
  return -1;
}

/** The longest edges of cells, each once, the longest first. */
std::vector<Measured> FindLongestEdges(const std::vector<Cell>& cells)
{
  std::vector<Measured> edges(cells.size());
  std::transform(cells.begin(), cells.end(), edges.begin(), FindLongestEdge);
  std::sort(edges.begin(), edges.end(), [](const Measured& a, const Measured& b) { return b < a; });
  edges.erase(std::unique(edges.begin(), edges.end(),
                [](const Measured& a, const Measured& b) { return a.Ends == b.Ends; }),
    edges.end());
  return edges;
}

/** Pushes the tetrahedra around a vertex, and those behind them. */
void PushNeighborhood(PiercedMesh& mesh, int vertex, std::vector<Cell>& cells)
{
  const PiercedMesh::Vertex v = mesh.GetVertex(vertex);
  std::vector<Cell> star;
  mesh.GetDelaunay().finite_incident_cells(v, std::back_inserter(star));
  for (const Cell& cell : star)
  {
    mesh.Push(cell, cells);
    mesh.Push(cell->neighbor(cell->index(v)), cells);
  }
}

} // namespace

std::size_t HalveKept(PiercedMesh& mesh, const SurfaceDistance& distance, double tolerance,
  std::size_t maximumPoints, int threads, const std::function<bool(double)>& progress)
{
  if (maximumPoints == 0)
  {
    return 0;
  }
  std::vector<Cell> changed;
  for (const Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    cell->info().Near = {};
    changed.push_back(cell);
  }
  std::size_t added = 0;
  while (!changed.empty())
  {
    progress(static_cast<double>(added) / static_cast<double>(maximumPoints));
    const std::vector<Cell> far = FindFar(mesh, changed, distance, tolerance, threads);
    std::vector<int> made;
    std::set<Edge> stuck; // cannot be halved as long as the mesh around them stays the same
    for (const Measured& edge : FindLongestEdges(far))
    {
      if (added == maximumPoints)
      {
        return added;
      }
      int vertex = SplitNearMiddle(mesh, FindTerminalEdge(mesh, edge));
      if (vertex < 0)
      {
        vertex = SplitNearMiddle(mesh, edge.Ends);
      }
      if (vertex >= 0)
      {
        made.push_back(vertex);
        ++added;
      }
      else
      {
        stuck.insert(edge.Ends);
      }
    }
    if (made.empty())
    {
      return added;
    }
    changed.clear();
    mesh.BeginWalk();
    for (const Cell& cell : far)
    {
      // Tetrahedra that are gone leave their places to others, or vacant.
      if (mesh.GetDelaunay().tds().cells().is_used(cell) &&
        stuck.count(FindLongestEdge(cell).Ends) == 0)
      {
        mesh.Push(cell, changed);
      }
    }
    for (const int vertex : made)
    {
      PushNeighborhood(mesh, vertex, changed);
    }
  }
  return added;
}

} // namespace carving::helper
