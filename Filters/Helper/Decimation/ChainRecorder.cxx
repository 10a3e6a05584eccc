// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/ChainRecorder.h"

#include <numeric>

namespace carving::helper
{
namespace
{

constexpr Triangle Removed = { -1, -1, -1 };

} // namespace

ChainRecorder::ChainRecorder(const SurfaceMesh& surface)
  : Points(PointsOf(surface))
  , PointOfVertex(Points.size())
{
  std::iota(this->PointOfVertex.begin(), this->PointOfVertex.end(), 0);
  this->Chain.Vertices = static_cast<int>(surface.number_of_vertices());
  this->Chain.Triangles = static_cast<int>(surface.number_of_faces());
  this->Now.reserve(surface.number_of_faces());
  for (const Face face : surface.faces())
  {
    this->Now.push_back({ this->CornersNow(surface, face), static_cast<int>(face), 0, 0 });
  }
}

Triangle ChainRecorder::CornersNow(const SurfaceMesh& surface, Face face) const
{
  Triangle corners;
  HalfEdge h = surface.halfedge(face);
  for (int& corner : corners)
  {
    corner = this->PointOfVertex[surface.source(h)];
    h = surface.next(h);
  }
  return corners;
}

void ChainRecorder::AddCollapse(
  const SurfaceMesh& surface, Vertex kept, Vertex removed, const std::vector<Face>& faces)
{
  const Point& w = surface.point(kept);
  if (w == this->Points[this->PointOfVertex[removed]])
  {
    this->PointOfVertex[kept] = this->PointOfVertex[removed];
  }
  else if (w != this->Points[this->PointOfVertex[kept]])
  {
    this->PointOfVertex[kept] = static_cast<int>(this->Points.size());
    this->Points.push_back(w);
  }
  ++this->Chain.Collapses;
  this->ReplaceAll(surface, faces, this->Chain.Collapses);
}

void ChainRecorder::AddMove(
  const SurfaceMesh& surface, Vertex vertex, const std::vector<Face>& faces)
{
  this->PointOfVertex[vertex] = static_cast<int>(this->Points.size());
  this->Points.push_back(surface.point(vertex));
  this->ReplaceAll(surface, faces, this->Chain.Collapses);
}

void ChainRecorder::AddMoveBack(
  const SurfaceMesh& surface, Vertex vertex, int point, const std::vector<Face>& faces)
{
  this->PointOfVertex[vertex] = point;
  this->ReplaceAll(surface, faces, this->Chain.Collapses + 1);
}

/** Takes over how faces are after a number of collapses. */
void ChainRecorder::ReplaceAll(
  const SurfaceMesh& surface, const std::vector<Face>& faces, int collapses)
{
  for (const Face face : faces)
  {
    const bool remains = !surface.is_removed(face);
    this->Replace(this->Now[face], remains ? this->CornersNow(surface, face) : Removed, collapses);
  }
}

void ChainRecorder::Replace(ChainFace& face, const Triangle& corners, int collapses)
{
  if (corners == face.Corners)
  {
    return;
  }
  if (face.Birth < collapses)
  {
    this->Past.push_back(face);
    this->Past.back().Death = collapses;
  }
  face.Corners = corners;
  face.Birth = collapses;
}

void ChainRecorder::Take(CollapseChain& chain, std::vector<Point>& points) &&
{
  chain = std::move(this->Chain);
  points = std::move(this->Points);
  this->PointOfVertex = {};
  chain.Faces.reserve(this->Past.size() + this->Now.size());
  chain.Faces.assign(this->Past.begin(), this->Past.end());
  this->Past.clear();
  for (const ChainFace& face : this->Now)
  {
    if (face.Corners != Removed)
    {
      chain.Faces.push_back(face);
      chain.Faces.back().Death = chain.Collapses + 1;
    }
  }
}

} // namespace carving::helper
