// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * A closed surface whose edges can collapse.
 */
#ifndef carving_SurfaceMesh_h
#define carving_SurfaceMesh_h

#include "Core/Mesh/BoxTree.h"
#include "Core/Mesh/Mesh.h"
#include "Helper/Decimation/FirstContact.h"

#include <CGAL/Surface_mesh.h>

#include <vector>

namespace carving::helper
{

using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Vertex = SurfaceMesh::Vertex_index;
using HalfEdge = SurfaceMesh::Halfedge_index;
using Face = SurfaceMesh::Face_index;

/** A closed surface as a mesh with the same indices of points and facets. */
SurfaceMesh AsSurfaceMesh(const ResolvedMesh& mesh);

/** A copy of the faces. Removed vertices keep their places. */
TriangleMesh AsTriangleMesh(const SurfaceMesh& mesh);

/** The corners of a face, counter-clockwise as seen from the outside. */
std::array<Point, 3> CornersOf(const SurfaceMesh& mesh, Face face);

std::vector<Point> PointsOf(const SurfaceMesh& mesh);

/** Whether the surface has a single component, and no two vertices at the same position. */
bool IsConnectedWithoutCopies(const SurfaceMesh& mesh);

/** The faces of a surface as items of a tree. The boxes of removed ones are empty. */
class FaceItems
{
public:
  /** The surface must outlive this object. */
  explicit FaceItems(const SurfaceMesh& surface)
    : Surface(&surface)
  {
  }

  std::size_t GetNumberOfItems() const
  {
    return this->Surface->number_of_faces() + this->Surface->number_of_removed_faces();
  }
  Box BoxOf(int face) const;

private:
  const SurfaceMesh* Surface;
};

/** The faces around the ends of an edge that may collapse, or around a vertex that may move. */
struct Star
{
  Star(const SurfaceMesh& mesh, HalfEdge edge);
  Star(const SurfaceMesh& mesh, Vertex vertex);

  /** The sum of the faces' normals, each as long as twice the face's area. */
  Point SumNormals() const;

  std::vector<Face> Faces;                   ///< the two that vanish with an edge come last
  std::vector<std::array<Point, 3>> Corners; ///< of each of these
  Fan Link; ///< the boundary of the star: an edge of each remaining face

private:
  void Reserve();
  void AddFace(const SurfaceMesh& mesh, HalfEdge spoke);
};

} // namespace carving::helper

#endif
