// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * A tetrahedralization in which edges of M are made.
 */
#ifndef carving_CutMesh_h
#define carving_CutMesh_h

#include "Helper/Cutting/Chains.h"
#include "Helper/Enclosing/PiercedMesh.h"

#include <vector>

namespace carving::helper
{

/** The mesh, the chains that edges of M have become, and the vertices added for them. */
class CutMesh
{
public:
  using Cell = PiercedMesh::Cell;

  /** What is within `tolerance` of a line or a plane counts as being on it. */
  CutMesh(PiercedMesh& mesh, double tolerance);

  /**
   * Makes an edge of M: tetrahedra on the way are flipped or split until the ends are connected by
   * edges on the line between them. Returns false if that fails.
   */
  bool Connect(int a, int b);

  /** Puts a vertex on an edge, by a share of the way from a to b. Returns it; -1 on failure. */
  int SplitEdge(int a, int b, double share);

  /** Whether an edge, given with all cells around it, has been flipped away. A link never is. */
  bool FlipEdge(int a, int b, const std::vector<Cell>& around);

  bool IsEdge(int a, int b) const;

  /**
   * Removes what was added since the last call, as far as M and the chains do not need it: most
   * vertices are needed for a moment only.
   */
  void Thin();

  /** Removes the first of the cells that is flat and can be removed. */
  void RemoveFlat(const std::vector<Cell>& cells);

  /**
   * Whether a flat tetrahedron that was in the way has been removed since the last call. What has
   * failed may then succeed.
   */
  bool TakeRepair();

  PiercedMesh& GetMesh()
  {
    return this->Mesh;
  }
  const PiercedMesh& GetMesh() const
  {
    return this->Mesh;
  }
  Chains& GetChains()
  {
    return this->Edges;
  }
  const Chains& GetChains() const
  {
    return this->Edges;
  }
  const Point& PointOf(int vertex) const
  {
    return this->Mesh.GetParts().GetPoints()[vertex];
  }
  double GetTolerance() const
  {
    return this->Tolerance;
  }
  /** A number for a patch, which no other has. */
  unsigned CountPatch()
  {
    return ++this->NumberOfPatches;
  }
  /** The number of changes that were tried. */
  std::size_t GetEffort() const
  {
    return this->Effort;
  }

private:
  struct Exit
  {
    Cell Of; ///< none if there is no way
    int Face;
    bool OnBorder; ///< of the face
  };

  int Step(int from, int to);
  Exit FindExit(int from, int to) const;
  int CrossFace(int from, int to, const Exit& exit);
  int FollowHull(int from, int to);
  int SplitFaceAt(const Cell& cell, int f, const Point& p);

  PiercedMesh& Mesh;
  double Tolerance;
  Chains Edges;
  PiercedMesh::EdgePredicate IsLink;
  std::vector<int> Added;
  bool IsRepaired = false;
  unsigned NumberOfPatches = 0;
  std::size_t Effort = 0;
};

} // namespace carving::helper

#endif
