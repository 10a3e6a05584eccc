// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Components of the remaining tetrahedra, glued at faces only.
 */
#ifndef carving_GluedParts_h
#define carving_GluedParts_h

#include "Core/Budget/FaceGraph.h"
#include "Core/Budget/RemainingCells.h"
#include "Core/Mesh/Mesh.h"

#include <vector>

namespace carving
{

/**
 * The number of components of N while tetrahedra are carved. N consists of all remaining
 * tetrahedra, including those of the solid, glued to each other at faces only. Parts of K that
 * touch only at edges and vertices are separate in N, as they may be on a level that has been cut
 * into manifolds: not counting the walls of voids, the surface of the level has at most as many
 * components as N.
 */
class GluedParts
{
public:
  /** Starts from C0, a ball. `cells`, whose states may change, must outlive this object. */
  GluedParts(const Decomposition<3>& mesh, const RemainingCells<3>& cells);

  /** Prefetches a cell that may soon be examined. */
  void Fetch(int cell) const
  {
    this->Graph.Fetch(cell);
  }

  /**
   * Returns labels per face of the cell: the components of N without the cell. Until MakeExact, two
   * neighbors have equal labels only if the tetrahedra around edges of the cell join them.
   */
  Labels<4> Examine(int cell);

  /** Carves a cell that has just been examined. */
  void Carve(int cell, const Labels<4>& labels);

  /** Notes that a cell that has just been examined exactly is kept for now. */
  void Keep(int cell, const Labels<4>& labels)
  {
    this->Graph.KeepAsBridge(cell, labels);
  }

  /** The number of components. Until MakeExact: an upper bound. */
  int GetComponents() const
  {
    return this->Components;
  }

  /** Counts the components in linear time; from then on all results are exact. */
  void MakeExact();
  bool IsExact() const
  {
    return this->Exact;
  }

private:
  bool IsBuried(int cell, int p, int q) const;

  const RemainingCells<3>& Cells;
  FaceGraph Graph;
  LockstepSearch<FaceGraph> Search;
  std::vector<char> OnSurface; ///< per vertex: whether the vertex adjoins the exterior
  int Components = 1;
  bool Exact = false;
};

} // namespace carving

#endif
