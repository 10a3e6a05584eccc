// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/SurfaceMesh.h"

#include "Core/Mesh/DisjointSets.h"

#include <algorithm>

namespace carving::helper
{

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

std::vector<Box> BoxesOf(const SurfaceMesh& mesh)
{
  std::vector<Box> boxes(mesh.num_faces());
  for (const Face face : mesh.faces())
  {
    for (const Point& p : CornersOf(mesh, face))
    {
      boxes[face].Add(p);
    }
  }
  return boxes;
}

EdgeStar::EdgeStar(const SurfaceMesh& mesh, HalfEdge edge)
{
  constexpr std::size_t usual = 16; // most stars have fewer faces
  this->Faces.reserve(usual);
  this->Corners.reserve(usual);
  this->Link.reserve(usual);
  const Face vanishing[] = { mesh.face(edge), mesh.face(mesh.opposite(edge)) };
  for (const HalfEdge start : { edge, mesh.opposite(edge) })
  {
    // Rotates around the source, from the face after one that vanishes to the other.
    const auto rotated = [&mesh](HalfEdge h) { return mesh.opposite(mesh.prev(h)); };
    for (HalfEdge h = rotated(start); mesh.face(h) != vanishing[0] && mesh.face(h) != vanishing[1];
         h = rotated(h))
    {
      const HalfEdge outer = mesh.next(h);
      this->Faces.push_back(mesh.face(h));
      this->Link.push_back({ mesh.point(mesh.source(outer)), mesh.point(mesh.target(outer)) });
    }
  }
  this->Faces.insert(this->Faces.end(), { vanishing[0], vanishing[1] });
  for (const Face face : this->Faces)
  {
    this->Corners.push_back(CornersOf(mesh, face));
  }
}

} // namespace carving::helper
