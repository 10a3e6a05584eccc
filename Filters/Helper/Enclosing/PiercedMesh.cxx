// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/PiercedMesh.h"

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

PiercedMesh::PiercedMesh(const ResolvedMesh& input, const std::vector<Point>& further, int threads,
  const std::function<bool(double)>& progress)
  : Parts(input)
{
  for (const Point& p : further)
  {
    this->Parts.AddPoint(p);
  }
  std::vector<std::pair<Inexact::Point_3, VertexInfo>> points;
  for (const Point& p : this->Parts.GetPoints())
  {
    VertexInfo info;
    info.Index = static_cast<int>(points.size());
    points.emplace_back(ToInexact(p), info);
  }
  this->Mesh.insert(points.begin(), points.end());
  this->Vertices.resize(points.size());
  for (const Vertex v : this->Mesh.finite_vertex_handles())
  {
    this->Vertices[v->info().Index] = v;
  }
  std::vector<int> parts(input.Facets.size());
  std::iota(parts.begin(), parts.end(), 0);
  this->SettleAll(std::move(parts), threads, progress);
}

Corners3 PiercedMesh::CornersOf(int part) const
{
  const Triangle& corners = this->Parts.GetParts()[part].Corners;
  return { this->Vertices[corners[0]]->point(), this->Vertices[corners[1]]->point(),
    this->Vertices[corners[2]]->point() };
}

} // namespace carving::helper
