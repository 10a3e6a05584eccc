// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Limits on the topology of every approximation of a carving.
 */
#ifndef carving_Budget_h
#define carving_Budget_h

#include "CarvedComplex.h"
#include "Carver.h"
#include "GluedCells.h"

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

  /** Order of a std::priority_queue: the greatest is popped first. */
  bool operator<(const Candidate& other) const
  {
    return this->Priority != other.Priority ? this->Priority < other.Priority
                                            : this->Cell > other.Cell;
  }
};

/**
 * Lets cells be carved as long as no limit is exceeded, and keeps the others aside.
 *
 * A cell that was refused waits for the number that it exceeds. While nothing about its own boundary
 * changes it never comes to need less, since components and tunnels that a removal makes only become more
 * as K shrinks; so it need not be looked at before there is room for as much.
 */
template <int D>
class Budget
{
public:
  /** Of all cells neither is carved yet; the mesh must outlive this object. */
  Budget(
    const Decomposition<D>& mesh, const std::vector<CellState>& states, const BettiNumbers& limits);

  /** Has the processor fetch a cell that will be needed soon. */
  void Fetch(int cell) const
  {
    this->Rest.Fetch(cell);
    if (this->Glued)
    {
      this->Glued->Fetch(cell);
    }
  }

  /** Whether the cell can be carved now; it is then counted as carved. If not it is put aside. */
  bool Admit(const Candidate& candidate);
  /** Those put aside for which the last admitted may have changed something. They no longer are. */
  const std::vector<int>& GetTakenBack() const
  {
    return this->TakenBack;
  }

  bool IsAside(int cell) const
  {
    return this->SlotOf[cell] >= 0;
  }

  /** The first of the cells put aside for which there has come to be room, or nullptr. */
  const Candidate* GetBest();
  /** Takes it back. */
  void PopBest();

  /**
   * Where nothing else can be carved: takes back those that the surface of what is left has kept aside and
   * that have been changed since; if there are none, the first for which there is room, if there is one.
   */
  std::vector<int> TakeBackLast();

private:
  static constexpr int Numbers = static_cast<int>(std::tuple_size_v<BettiNumbers>);
  static constexpr int Amounts = 3; ///< no removal adds more to any of them

  // Of components and tunnels, for those that only the cut surface refuses.
  static constexpr int GluedSlots = Amounts * Numbers;
  static constexpr int GluedAmounts = 6; ///< as before: no more edges than that can fall apart
  static constexpr int NumberOfSlots = GluedSlots + 2 * GluedAmounts;

  int GetRoom(int number) const;
  int GetGluedRoom(int number) const;
  int GetRoomFor(int slot) const;
  bool PutAside(const Candidate& candidate, int slot);
  int FindSlot(const Removal<D>& removal) const;
  int FindGluedSlot(int cell, GluedRemoval& removal);
  const Candidate* FindBest(int firstSlot, int lastSlot);
  bool ComesBack(int cell);
  void TakeBack(int cell, const Removal<D>& removal);

  CarvedComplex<D> Rest;
  std::unique_ptr<GluedCells> Glued; ///< null in the plane and where only voids are limited
  BettiNumbers Limits;
  /** Slot `Amounts * number + amount - 1` and so on: what a cell waits for. Cells taken back remain. */
  std::array<std::priority_queue<Candidate>, NumberOfSlots> Waiting;
  std::vector<signed char> SlotOf; ///< per cell; -1 if it is not aside
  int NumberAside = 0;
  int BestSlot = 0;
  bool MayBeLess = false; ///< the components of Glued
  std::vector<int> TakenBack;
};

} // namespace carving

#endif
