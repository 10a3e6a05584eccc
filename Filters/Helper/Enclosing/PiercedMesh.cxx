// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/PiercedMesh.h"

#include <algorithm>
#include <numeric>

namespace carving::helper
{

Corners4 CornersOf(const PiercedMesh::Cell& cell)
{
  return { cell->vertex(0)->point(), cell->vertex(1)->point(), cell->vertex(2)->point(),
    cell->vertex(3)->point() };
}

Corners3 FaceOf(const PiercedMesh::Cell& cell, int f)
{
  Corners3 face;
  for (int i = 0; i < 3; ++i)
  {
    face[i] = cell->vertex(FaceCorners[f][i])->point();
  }
  return face;
}

PiercedMesh::PiercedMesh(Delaunay&& delaunay, const ResolvedMesh& input,
  const std::vector<Point>& further, int threads, const std::function<bool(double)>& progress)
  : Parts(input)
{
  for (const Point& p : further)
  {
    this->Parts.AddPoint(p);
  }
  this->Mesh.swap(delaunay);
  this->Vertices.resize(this->Parts.GetPoints().size());
  for (const Vertex v : this->Mesh.finite_vertex_handles())
  {
    this->Vertices[v->info().Index] = v;
  }
  std::vector<int> parts(input.Facets.size());
  std::iota(parts.begin(), parts.end(), 0);
  this->SettleAll(std::move(parts), threads, progress);
}

PiercedMesh::PiercedMesh(const ResolvedMesh& input, const std::vector<Point>& further, int threads,
  const std::function<bool(double)>& progress)
  : PiercedMesh(Tetrahedralize(input.Points, further), input, further, threads, progress)
{
}

PiercedMesh::Delaunay PiercedMesh::Tetrahedralize(
  const std::vector<Point>& points, const std::vector<Point>& further)
{
  std::vector<std::pair<Inexact::Point_3, VertexInfo>> vertices;
  for (const std::vector<Point>* some : { &points, &further })
  {
    for (const Point& p : *some)
    {
      VertexInfo info;
      info.Index = static_cast<int>(vertices.size());
      vertices.emplace_back(ToInexact(p), info);
    }
  }
  Delaunay delaunay;
  delaunay.insert(vertices.begin(), vertices.end());
  return delaunay;
}

Corners3 PiercedMesh::CornersOf(int part) const
{
  const Triangle& corners = this->Parts.GetParts()[part].Corners;
  return { this->Vertices[corners[0]]->point(), this->Vertices[corners[1]]->point(),
    this->Vertices[corners[2]]->point() };
}

std::optional<PiercedMesh::Delaunay::Edge> PiercedMesh::FindEdge(int a, int b) const
{
  if (this->IsStill(this->LastEdge, a, b))
  {
    return this->LastEdge;
  }
  // CGAL searches the cells around the first vertex. Vertices that were added have few.
  const auto [lower, upper] = std::minmax(a, b);
  Cell cell;
  int i = 0, j = 0;
  return this->Mesh.tds().is_edge(this->Vertices[upper], this->Vertices[lower], cell, i, j)
    ? std::optional(upper == a ? Delaunay::Edge(cell, i, j) : Delaunay::Edge(cell, j, i))
    : std::nullopt;
}

/** Whether there is still an edge, and it is the one from a to b. */
bool PiercedMesh::IsStill(const Delaunay::Edge& edge, int a, int b) const
{
  const auto& [cell, i, j] = edge;
  return cell != Cell() && this->Mesh.tds().cells().is_used(cell) &&
    cell->vertex(i) == this->Vertices[a] && cell->vertex(j) == this->Vertices[b];
}

std::vector<PiercedMesh::Cell> PiercedMesh::FindCellsAround(
  int a, int b, const Delaunay::Edge& hint) const
{
  const std::optional<Delaunay::Edge> edge =
    this->IsStill(hint, a, b) ? hint : this->FindEdge(a, b);
  return edge ? this->FindCellsAround(*edge) : std::vector<Cell>();
}

std::vector<PiercedMesh::Cell> PiercedMesh::FindCellsAround(const Delaunay::Edge& edge) const
{
  this->LastEdge = edge;
  std::vector<Cell> cells;
  auto at = this->Mesh.tds().incident_cells(edge);
  const Cell first = at;
  do
  {
    cells.push_back(at);
    ++at;
  } while (Cell(at) != first);
  return cells;
}

} // namespace carving::helper
