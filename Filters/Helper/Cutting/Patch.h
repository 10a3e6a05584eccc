// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * A triangle of M between edges that have been made.
 */
#ifndef carving_Patch_h
#define carving_Patch_h

#include "Helper/Cutting/CutMesh.h"

#include <vector>

namespace carving::helper
{

/** Makes a triangle a union of faces, and finds these faces. */
class Patch
{
public:
  /** The edges of the triangle must be connected. */
  Patch(CutMesh& mesh, const Triangle& corners);

  /**
   * Removes all edges of tetrahedra that cross the triangle: by flips, or by a vertex at the
   * crossing. Returns false if that fails.
   */
  bool CutEdges();

  /** The faces that the triangle consists of, oriented as it; none if they are no disk. */
  std::vector<Triangle> FindFaces();

  /** The cells on the plane that are at the border: they may hide faces. */
  std::vector<PiercedMesh::Cell> FindFlat();

private:
  using Cell = PiercedMesh::Cell;
  using Edge = std::array<int, 2>;
  using CellEdge = PiercedMesh::Delaunay::Edge; ///< a cell, and which of its corners

  /** The third corner of a face on the left of an edge, and a cell that has the face. */
  struct Left
  {
    int Corner = -1; ///< none if there is no such face
    Cell Of;
  };

  void RemoveSpurs();
  bool IsSimple() const;
  void PutOnPlane(int vertex);
  int SideOf(const PiercedMesh::Vertex& v);
  std::vector<std::pair<Edge, CellEdge>> FindCrossing();
  bool IsOnSide(const Cell& cell, int side);
  bool IsFace(const Cell& cell, int f, int side);
  Left FindLeft(const CellEdge& edge, int side);
  std::vector<Triangle> FindFaces(int side);

  CutMesh& Mesh;
  Triangle Corners;
  Corners3 CornerPoints;
  Point Normal;          ///< of length 1; 0 if the triangle has no area
  std::vector<int> Loop; ///< all vertices on the border, in the direction of the triangle
  unsigned Number;       ///< marks the vertices whose side is known
};

} // namespace carving::helper

#endif
