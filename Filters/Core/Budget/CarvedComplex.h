// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What carving one more cell does to the topology of what is left.
 */
#ifndef carving_CarvedComplex_h
#define carving_CarvedComplex_h

#include "Core/Budget/Connectivity.h"
#include "Core/Budget/RemainingCells.h"
#include "Core/Mesh/BettiNumbers.h"
#include "Core/Mesh/Mesh.h"

#include <array>
#include <vector>

namespace carving
{

/** What would change if a cell were carved. */
template <int D>
struct Removal
{
  /** Of the number of components, tunnels and voids. */
  BettiNumbers Change = {};
  /** Per corner of the cell, a number for its component of what would be left; -1 where it would be gone. */
  typename Connectivity<D>::Labels Components = {};
  /** Of a tetrahedron: the edges that others hold, but none behind its faces. */
  std::array<bool, 6> HeldEdges = {};
};

/**
 * The Betti numbers of K, the closed complex of M, the solid and all cells that are not carved, while
 * cells are carved.
 *
 * Of the boundary of a cell T, a sphere, A is what other cells of K or facets of M hold. By the
 * Mayer-Vietoris sequence of K = K' + T with the intersection A, where all of the exterior around T is in
 * one piece (T opens onto what has been carved before of its region):
 * - A is the whole sphere: a void begins (in the plane, a tunnel).
 * - Otherwise A has a pieces and l loops, which follow from its Euler characteristic. The pieces belong to
 *   c components of K', so that c - 1 components split off, a - c tunnels end and l begin.
 *
 * A is found by turning around the edges of T. Only c is not local, and even that is where there is one
 * piece, or no tunnel that could end.
 */
template <int D>
class CarvedComplex
{
public:
  /** Starts from C0, a ball. */
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

  /** Has the processor fetch what it needs to know of a cell that may soon be examined. */
  void Fetch(int cell) const
  {
    __builtin_prefetch(&this->Cells.Records[cell]);
  }

  /** The cell must adjoin the exterior, or begin a region that M encloses. */
  Removal<D> Examine(int cell);

  /**
   * Until then, pieces of A count as components of their own: no component and no tunnel is missed, but there
   * may be less, and as many of both.
   */
  void MakeExact();
  bool GetIsExact() const
  {
    return this->IsExact;
  }

  /** The cell is carved. */
  void Carve(int cell, const Removal<D>& removal);

  /** The cell stays although K would fall apart without it. */
  void Keep(int cell, const Removal<D>& removal);

  /**
   * Appends the cells that are left and behind a face of the cell, which has just been carved, or alone
   * hold an edge or a vertex of it. What carving them would change may have become another.
   */
  void FindTouched(int cell, const Removal<D>& removal, std::vector<int>& touched) const;

private:
  bool IsFaceHeld(int cell, int f) const;

  RemainingCells<D> Cells;
  Connectivity<D> Rest;
  BettiNumbers Numbers = { 1, 0, 0 };
  bool IsExact = D == 2;
  /**
   * Per vertex: how many of the cells that may be carved are left around it, and their indices combined
   * by exclusive or, which of one is its index; -1 for a vertex of M or of a cell that stays for good.
   */
  std::vector<std::array<int, 2>> Around;
};

} // namespace carving

#endif
