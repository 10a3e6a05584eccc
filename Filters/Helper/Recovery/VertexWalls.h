// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The walls around a vertex: parts of M, and of the convex hull.
 */
#ifndef carving_VertexWalls_h
#define carving_VertexWalls_h

#include "Helper/Recovery/SpaceFilling.h"

#include <array>
#include <vector>

namespace carving::helper
{

/**
 * The walls at a vertex that is inside of triangles or edges of M, and the spaces between the
 * walls.
 */
class VertexWalls
{
public:
  VertexWalls(const PiercedMesh& mesh, const PiercedMesh::Vertex& v);

  /** Finds triangles that cover the walls without the vertex. Returns whether that succeeded. */
  bool Retriangulate();

  /** The cells around the vertex between walls, and the walls without the vertex. */
  struct Space
  {
    std::vector<PiercedMesh::Cell> Cells;
    /** Tetrahedra with a fourth corner in the space are oriented positively. */
    std::vector<VertexTriangle> Walls;
  };
  std::vector<Space> GetSpaces() const;

  /** The parts that have the vertex. */
  std::vector<int> GetParts() const;

  /** The parts in their places, without the vertex. */
  std::vector<Subdivision::Part> MakeParts() const;

  /** All cells around the vertex. */
  const std::vector<PiercedMesh::Cell>& GetStar() const
  {
    return this->Star;
  }

private:
  /** A face at the vertex. */
  struct Face
  {
    PiercedMesh::Vertex From, To; ///< counter-clockwise about the vertex when seen from the front
    int Part;                     ///< -1: the hull
    int Parent;
    std::array<int, 2> Cells; ///< in front and behind, as indices into the star
    bool IsTraced = false;

    void BeginAt(int vertex);
  };

  /** The faces at the vertex that are parts of one triangle of M, or else of the hull. */
  struct Wall
  {
    int Parent;                            ///< the triangle of M; -1: the hull
    std::vector<PiercedMesh::Vertex> Rim;  ///< counter-clockwise when seen from the front
    std::array<int, 2> Spaces;             ///< in front and behind
    std::vector<VertexTriangle> Triangles; ///< the same area without the vertex
  };

  bool FindFaces();
  Face MakeFace(const PiercedMesh::Cell& cell, int f) const;
  void ExtendOpenEdge();
  std::vector<PiercedMesh::Vertex> FindOpenEnds() const;
  void FindSpaces();
  void Trace();
  int FindNext(const Face& face, bool forwards) const;

  const PiercedMesh& Mesh;
  PiercedMesh::Vertex V;
  std::vector<PiercedMesh::Cell> Star;
  std::vector<Face> Faces;
  std::vector<int> SpaceOf; ///< per cell of the star
  int NumberOfSpaces = 0;
  std::vector<Wall> Walls;
};

} // namespace carving::helper

#endif
