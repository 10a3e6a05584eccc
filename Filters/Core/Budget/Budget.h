// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Budgets: limits on the numbers of components, tunnels and voids of every approximation.
 *
 * Budgets are not in the paper, where carving removes the whole complement. With a budget, carving
 * defers every tetrahedron whose removal would exceed a limit, and continues with the others. Each
 * removal stays within the limits, and so does each approximation.
 *
 * Two questions decide whether a cell can be carved:
 * - How would its removal change the Betti numbers of K, the closed complex of M, the solid and all
 *   remaining cells? The Mayer-Vietoris sequence gives the change from the part of the cell's
 *   boundary that the cell shares with the rest of K. See CarvedComplex. Rotations around the edges
 *   of the cell (EdgeRotation) find this part.
 * - How would its removal change the number of components of N, the remaining tetrahedra glued at
 *   faces only? In space, manifold cutting may separate parts of K that touch only at edges and
 *   vertices. So a limit of components applies to N as well as to K. See GluedParts.
 *
 * Both answers are local, except for one fact: whether the pieces around the cell are joined
 * elsewhere. A LockstepSearch finds out, for K on a VertexGraph and for N on a FaceGraph. Nothing
 * is searched as long as no limit is near: pieces that are not joined around the cell count as
 * separate, which gives upper bounds. When a removal would exceed a limit by these bounds, the
 * components are counted, and all later counts are exact.
 *
 * RemainingCells contains the cells and their states, and Labels the labels of pieces.
 */
#ifndef carving_Budget_h
#define carving_Budget_h

#include "Core/Budget/CarvedComplex.h"
#include "Core/Budget/GluedParts.h"
#include "Core/Mesh/BettiNumbers.h"

#include <array>
#include <memory>
#include <queue>
#include <tuple>
#include <vector>

namespace carving
{

/** A cell that may be carved, in a queue. */
struct Candidate
{
  double Priority;
  int Cell;

  /** The order of a std::priority_queue: the greatest is popped first. */
  bool operator<(const Candidate& other) const
  {
    return this->Priority != other.Priority ? this->Priority < other.Priority
                                            : this->Cell > other.Cell;
  }
};

/**
 * Admits cells to be carved while no limit is exceeded, and defers the others.
 *
 * A deferred cell waits for room below the limit that its removal would exceed. The cell is not
 * examined again before there is enough room, or the part of its boundary that it shares with K
 * changes. While that part stays the same, the cell never needs less room: the numbers of
 * components and tunnels that its removal would add can only grow as K shrinks.
 */
template <int D>
class Budget
{
public:
  /** No cell is carved yet. A negative limit is none. The mesh must outlive this object. */
  Budget(
    const Decomposition<D>& mesh, const std::vector<CellState>& states, const BettiNumbers& limits);

  /** Prefetches a cell that may soon be examined. */
  void Fetch(int cell) const
  {
    this->Complex.Fetch(cell);
    if (this->Glued)
    {
      this->Glued->Fetch(cell);
    }
  }

  /**
   * Returns whether the cell can be carved now. If so, counts it as carved; otherwise defers it.
   */
  bool Admit(const Candidate& candidate);

  /**
   * The cells that are no longer deferred, because the last admitted cell may have affected them.
   */
  const std::vector<int>& GetRequeued() const
  {
    return this->Requeued;
  }

  bool IsDeferred(int cell) const
  {
    return this->ShortageOf[cell].Amount > 0;
  }

  /** The first of the deferred cells for which there is enough room, or nullptr. */
  const Candidate* GetBest();
  /** Ends the deferral of the cell that GetBest has just returned. */
  void PopBest();

private:
  /** The limited numbers: the Betti numbers of K, and the components of N. */
  static constexpr int NumberOfBettiNumbers = static_cast<int>(std::tuple_size_v<BettiNumbers>);
  static constexpr int GluedComponents = NumberOfBettiNumbers;
  static constexpr int NumberOfLimits = NumberOfBettiNumbers + 1;
  /** No removal adds more to a limited number. */
  static constexpr int LargestAmount = 3;

  /** The room that a deferred cell needs. */
  struct Shortage
  {
    signed char Number = 0;
    signed char Amount = 0; ///< 0: the cell is not deferred
  };

  int GetRoom(int number) const;
  Shortage FindShortage(int number, int change) const;
  Shortage FindShortage(const RemovalEffect<D>& effect) const;
  Shortage ExamineComplex(int cell, RemovalEffect<D>& effect);
  Shortage ExamineGlued(int cell, Labels<4>& labels);
  void Defer(const Candidate& candidate, Shortage shortage);
  bool Release(int cell);
  void Requeue(int cell, const RemovalEffect<D>& effect);

  CarvedComplex<D> Complex;
  std::unique_ptr<GluedParts> Glued; ///< null in the plane and where components are not limited
  BettiNumbers Limits;
  /** By number and amount - 1. A queue may contain cells that no longer wait in it. */
  std::array<std::array<std::priority_queue<Candidate>, LargestAmount>, NumberOfLimits> Waiting;
  std::vector<Shortage> ShortageOf; ///< per cell
  int NumberDeferred = 0;
  std::priority_queue<Candidate>* BestQueue = nullptr; ///< the queue of the last GetBest
  std::vector<int> Requeued;
};

} // namespace carving

#endif
