// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether tetrahedra that are glued at faces still hang together without one of them.
 */
#ifndef carving_GluedParts_h
#define carving_GluedParts_h

#include "Core/Budget/RemainingCells.h"

#include <array>
#include <cstddef>
#include <vector>

namespace carving
{

/**
 * N: the tetrahedra that are left, the solid's too, glued to each other at faces only. Where they touch in
 * edges and vertices alone, N is apart; so a level's surface has no more pieces, not counting walls of voids.
 */
class GluedParts
{
public:
  /** Per face of a tetrahedron: equal for those behind which the others hang together, -1 for no other. */
  using Labels = std::array<int, 4>;

  /** Starts from C0, a ball. Follows what is left, which must outlive it. */
  GluedParts(const Decomposition<3>& mesh, const RemainingCells<3>& cells);

  /** Has the processor fetch what it needs to know of a cell that may soon be examined. */
  void Fetch(int cell) const
  {
    __builtin_prefetch(&this->Nodes[cell]);
  }

  /** Which faces the others hang together behind, around its edges; until exact, joined nowhere else. */
  Labels Examine(int cell);
  /** Merges the labels of faces behind which the others hang together, be it anywhere. */
  void Join(int cell, Labels& labels);
  void Carve(int cell, const Labels& labels);
  /**
   * The tetrahedron stays although the others would fall apart so without it. They can only be joined through
   * it, for as long as it stays: no other search has to go through it from one to the other.
   */
  void KeepAsBridge(int cell, const Labels& labels);
  /** How many of those behind the faces with a label are known to be apart without it. */
  int CountSides(int cell, const Labels& labels) const;

  /** How many components there are, at most. */
  int GetComponents() const
  {
    return this->Components;
  }
  /** Has them counted. The number stays exact if from then on labels are joined before they are carved. */
  void MakeExact();
  bool GetIsExact() const
  {
    return this->IsExact;
  }

private:
  bool IsBuried(int cell, int p, int q) const;
  void Reach(int cell, int from, int f, Labels& labels);
  bool AreSeveralOpen(const Labels& labels, const std::array<std::size_t, 4>& next) const;
  int SideOf(int cell, int f) const
  {
    return this->Nodes[cell].Sides >> (2 * f) & 3;
  }

  /** A cell, as searches see it. */
  struct Node
  {
    int ReachedBy = -1; ///< 4 times the number of the last search, plus the face; or Gone
    int Block = -1;     ///< the first cell of the part of what stays for good that it belongs to
    int BlockReachedBy = -1; ///< of such a first cell
    unsigned char Sides = 0; ///< faces with the same number are on one side of it
  };

  const RemainingCells<3>& Cells;
  std::vector<Node> Nodes;
  std::vector<char> Touched; ///< per vertex: whether the exterior is somewhere around it
  /** Of a search from behind the faces of a tetrahedron: 4 times a cell, plus the face it was entered by. */
  std::array<std::vector<int>, 4> Reached;
  int Components = 1;
  bool IsExact = false;
  int Search = 0;
};

} // namespace carving

#endif
