// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Betti numbers of K, and how the removal of a cell changes them.
 */
#ifndef carving_CarvedComplex_h
#define carving_CarvedComplex_h

#include "Core/Budget/LockstepSearch.h"
#include "Core/Budget/RemainingCells.h"
#include "Core/Budget/VertexGraph.h"
#include "Core/Mesh/BettiNumbers.h"
#include "Core/Mesh/Fetch.h"
#include "Core/Mesh/Mesh.h"

#include <array>
#include <vector>

namespace carving
{

/** The changes that the removal of a cell makes. */
template <int D>
struct RemovalEffect
{
  /** Changes of the numbers of components, tunnels and voids. */
  BettiNumbers Change = {};
  /** Per corner: its component of K without the cell. Set where a component may split. */
  Labels<D + 1> Components = {};
  /**
   * Per edge of a tetrahedron, from corner p to corner q < p, entry [p][q]: whether other cells or
   * M share the edge but neither of the tetrahedron's two faces at the edge.
   */
  std::array<std::array<bool, 4>, 4> SharedEdges = {};
};

/**
 * The Betti numbers of K, the closed complex of M, the solid and all remaining cells, while cells
 * are carved. The paper does not compute Betti numbers.
 *
 * Let T be a cell and K' the complex K without T. A, the intersection of K' and T, is the part of
 * T's boundary that T shares with other cells or with facets of M. All exterior around T is
 * connected, since T opens onto the carved part of its own region. The Mayer-Vietoris sequence of
 * K, the union of K' and T, then says:
 * - If A is the whole boundary, a void opens (in the plane, a tunnel).
 * - Otherwise let A have a pieces and l loops, and let the pieces belong to c components of K'.
 *   Then c - 1 components split off, a - c tunnels end and l tunnels open.
 *
 * The numbers a and l are local: rotations around the edges of T find A, and its Euler
 * characteristic is a - l. Only c may require a search of K', and only if A has several pieces and
 * there is a tunnel that could end.
 */
template <int D>
class CarvedComplex
{
public:
  /** Starts from C0, a ball. The mesh must outlive this object. */
  CarvedComplex(const Decomposition<D>& mesh, const std::vector<CellState>& states);
  CarvedComplex(const CarvedComplex&) = delete;
  void operator=(const CarvedComplex&) = delete;

  const BettiNumbers& GetBettiNumbers() const
  {
    return this->Numbers;
  }

  const RemainingCells<D>& GetCells() const
  {
    return this->Cells;
  }

  /** Prefetches a cell that may soon be examined. */
  void Fetch(int cell) const
  {
    Prefetch(&this->Cells.Records[cell]);
  }

  /** The cell must adjoin the exterior, or be the first of a void. */
  RemovalEffect<D> Examine(int cell);

  /**
   * Counts the components in linear time; from then on all results are exact. Before, every piece
   * of A counts as a component: the numbers of components and tunnels are upper bounds, too high by
   * the same amount.
   */
  void MakeExact();
  bool IsExact() const
  {
    return this->Exact;
  }

  /** Carves a cell that has just been examined. */
  void Carve(int cell, const RemovalEffect<D>& effect);

  /** Notes that a cell that has just been examined exactly is kept for now. */
  void Keep(int cell, const RemovalEffect<D>& effect);

  /**
   * Appends the remaining cells whose boundary may share less with K since `cell`, the last one,
   * was carved: its neighbors and the cells that are now alone at one of its edges or vertices.
   */
  void FindAffected(int cell, const RemovalEffect<D>& effect, std::vector<int>& affected) const;

private:
  using Faces = std::array<bool, D + 1>;

  /** The carvable cells that remain around a vertex. */
  struct Star
  {
    int Count;    ///< -1 for a vertex of M or of a permanent cell
    int Combined; ///< the exclusive or of their indices: the index of the last one
  };

  Faces FindSharedFaces(int cell) const;
  bool IsEdgeShared(
    int cell, int p, int q, const Faces& sharedFaces, RemovalEffect<D>& effect) const;
  void ExamineEdge(int cell, const Faces& sharedFaces, RemovalEffect<D>& effect) const;
  void ExaminePieces(int cell, const Faces& sharedFaces, RemovalEffect<D>& effect);

  RemainingCells<D> Cells;
  VertexGraph<D> Graph;
  LockstepSearch<VertexGraph<D>> Search;
  BettiNumbers Numbers = { 1, 0, 0 };
  bool Exact = D == 2;
  std::vector<Star> Stars; ///< per vertex
};

} // namespace carving

#endif
