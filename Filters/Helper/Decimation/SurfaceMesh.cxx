// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/SurfaceMesh.h"

#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

HalfEdge RotatedAroundSource(const SurfaceMesh& mesh, HalfEdge h)
{
  return mesh.opposite(mesh.prev(h));
}

} // namespace

SurfaceMesh AsSurfaceMesh(const ResolvedMesh& mesh)
{
  SurfaceMesh surface;
  surface.reserve(static_cast<SurfaceMesh::size_type>(mesh.Points.size()),
    static_cast<SurfaceMesh::size_type>(3 * mesh.Facets.size() / 2),
    static_cast<SurfaceMesh::size_type>(mesh.Facets.size()));
  for (const Point& p : mesh.Points)
  {
    surface.add_vertex(p);
  }
  for (const auto& [a, b, c] : mesh.Facets)
  {
    surface.add_face(Vertex(a), Vertex(b), Vertex(c));
  }
  return surface;
}

std::array<Point, 3> CornersOf(const SurfaceMesh& mesh, Face face)
{
  const HalfEdge h = mesh.halfedge(face);
  return { mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
    mesh.point(mesh.target(mesh.next(h))) };
}

std::vector<Point> PointsOf(const SurfaceMesh& mesh)
{
  std::vector<Point> points;
  for (const Vertex v : mesh.vertices())
  {
    points.push_back(mesh.point(v));
  }
  return points;
}

TriangleMesh AsTriangleMesh(const SurfaceMesh& mesh)
{
  TriangleMesh copy;
  copy.Points.resize(mesh.num_vertices());
  for (const Vertex vertex : mesh.vertices())
  {
    copy.Points[vertex] = mesh.point(vertex);
  }
  copy.Triangles.reserve(mesh.number_of_faces());
  for (const Face face : mesh.faces())
  {
    Triangle& corners = copy.Triangles.emplace_back();
    std::size_t k = 0;
    for (const Vertex vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
    {
      corners[k++] = static_cast<int>(vertex);
    }
  }
  return copy;
}

bool IsConnectedWithoutCopies(const SurfaceMesh& mesh)
{
  DisjointSets components(mesh.num_vertices());
  for (const auto edge : mesh.edges())
  {
    components.Unite(mesh.vertex(edge, 0), mesh.vertex(edge, 1));
  }
  int numberOfComponents = 0;
  for (const Vertex v : mesh.vertices())
  {
    numberOfComponents += components.Find(v) == static_cast<int>(v);
  }
  std::vector<Point> points = PointsOf(mesh);
  std::sort(points.begin(), points.end());
  return numberOfComponents == 1 &&
    std::adjacent_find(points.begin(), points.end()) == points.end();
}

Box FaceItems::BoxOf(int face) const
{
  const Face index(face);
  return this->Surface->is_removed(index) ? Box() : BoxAround(CornersOf(*this->Surface, index));
}

Star::Star(const SurfaceMesh& mesh, HalfEdge edge)
{
  this->Reserve();
  const Face vanishing[] = { mesh.face(edge), mesh.face(mesh.opposite(edge)) };
  for (const HalfEdge start : { edge, mesh.opposite(edge) })
  {
    // From the face after one that vanishes to the other.
    for (HalfEdge h = RotatedAroundSource(mesh, start);
         mesh.face(h) != vanishing[0] && mesh.face(h) != vanishing[1];
         h = RotatedAroundSource(mesh, h))
    {
      this->AddFace(mesh, h);
    }
  }
  for (const Face face : vanishing)
  {
    this->Faces.push_back(face);
    this->Corners.push_back(CornersOf(mesh, face));
  }
}

Star::Star(const SurfaceMesh& mesh, Vertex vertex)
{
  this->Reserve();
  const HalfEdge first = mesh.opposite(mesh.halfedge(vertex));
  HalfEdge h = first;
  do
  {
    this->AddFace(mesh, h);
    h = RotatedAroundSource(mesh, h);
  } while (h != first);
}

Point Star::SumNormals() const
{
  Point sum = {};
  for (const auto& [a, b, c] : this->Corners)
  {
    sum = sum + Cross(b - a, c - a);
  }
  return sum;
}

void Star::Reserve()
{
  constexpr std::size_t usual = 16; // most stars have fewer faces
  this->Faces.reserve(usual);
  this->Corners.reserve(usual);
  this->Link.reserve(usual);
}

/** Adds the face of a half-edge from a vertex in the middle of the star. */
void Star::AddFace(const SurfaceMesh& mesh, HalfEdge spoke)
{
  const HalfEdge outer = mesh.next(spoke);
  this->Faces.push_back(mesh.face(spoke));
  this->Corners.push_back(CornersOf(mesh, this->Faces.back()));
  this->Link.push_back({ mesh.point(mesh.source(outer)), mesh.point(mesh.target(outer)) });
}

} // namespace carving::helper
