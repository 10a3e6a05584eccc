// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Limits on the topology of every approximation of a carving.
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
    if (this->Parts)
    {
      this->Parts->Fetch(cell);
    }
  }

  /** Whether the cell can be carved now; it is then counted as carved. If not it is put aside. */
  bool Admit(const Candidate& candidate);
  /** Those put aside for which the last admitted may have changed something. They no longer are. */
  const std::vector<int>& GetRequeued() const
  {
    return this->Requeued;
  }

  bool IsDeferred(int cell) const
  {
    return this->SlotOf[cell] >= 0;
  }

  /** The first of the cells put aside for which there has come to be room, or nullptr. */
  const Candidate* GetBest();
  /** Takes it back. */
  void PopBest();

private:
  static constexpr int Numbers = static_cast<int>(std::tuple_size_v<BettiNumbers>);
  static constexpr int Amounts = 3; ///< no removal adds more to any of them

  /** Of components, for those that only the cut surface would have too many of. */
  static constexpr int PartsSlots = Amounts * Numbers;
  static constexpr int NumberOfSlots = PartsSlots + Amounts;

  int GetRoom(int number) const;
  bool Defer(const Candidate& candidate, int slot);
  int FindSlot(const Removal<D>& removal) const;
  int FindPartsSlot(int cell, GluedParts::Labels& labels);
  bool Release(int cell);
  void Requeue(int cell, const Removal<D>& removal);

  CarvedComplex<D> Rest;
  std::unique_ptr<GluedParts> Parts; ///< null in the plane and where components are not limited
  BettiNumbers Limits;
  /** Slot `Amounts * number + amount - 1` and so on: what a cell waits for. Cells taken back remain. */
  std::array<std::priority_queue<Candidate>, NumberOfSlots> Waiting;
  std::vector<signed char> SlotOf; ///< per cell; -1 if it is not aside
  int NumberDeferred = 0;
  int BestSlot = 0;
  std::vector<int> Requeued;
};

} // namespace carving

#endif
