// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Budget/Budget.h"

#include <algorithm>
#include <limits>

namespace carving
{

template <int D>
Budget<D>::Budget(
  const Decomposition<D>& mesh, const std::vector<CellState>& states, const BettiNumbers& limits)
  : Rest(mesh, states)
  , Limits(limits)
  , SlotOf(mesh.Cells.size(), -1)
{
  this->Limits[0] = limits[0] == 0 ? 1 : limits[0];
  for (int& limit : this->Limits)
  {
    limit = limit < 0 ? std::numeric_limits<int>::max() : limit;
  }
  if constexpr (D == 3)
  {
    if (limits[0] >= 0)
    {
      this->Parts = std::make_unique<GluedParts>(mesh, this->Rest.GetCells());
    }
  }
}

/** How many more there may be of one of the numbers, or of the pieces of the cut surface. */
template <int D>
int Budget<D>::GetRoom(int number) const
{
  return number < Numbers ? this->Limits[number] - this->Rest.GetBettiNumbers()[number]
                          : this->Limits[0] - this->Parts->GetComponents();
}

template <int D>
bool Budget<D>::Defer(const Candidate& candidate, int slot)
{
  this->Waiting[slot].push(candidate);
  this->SlotOf[candidate.Cell] = static_cast<signed char>(slot);
  ++this->NumberDeferred;
  return false;
}

/**
 * For what a cell would have to wait if the surface is cut without it, or -1 if it would stay within the
 * limit. `labels` is what carving it would leave.
 */
template <int D>
int Budget<D>::FindPartsSlot(int cell, GluedParts::Labels& labels)
{
  GluedParts& parts = *this->Parts;
  labels = parts.Examine(cell);
  if (CountLabels(labels) - 1 > this->GetRoom(Numbers) && !parts.GetIsExact())
  {
    parts.MakeExact();
  }
  if (CountLabels(labels) < 2 || !parts.GetIsExact())
  {
    return -1;
  }
  const auto findSlot = [&](int count)
  { return count - 1 > this->GetRoom(Numbers) ? PartsSlots + count - 2 : -1; };
  if (const int slot = findSlot(parts.CountSides(cell, labels)); slot >= 0)
  {
    return slot;
  }
  parts.Join(cell, labels);
  const int slot = findSlot(CountLabels(labels));
  if (slot >= 0)
  {
    parts.KeepAsBridge(cell, labels);
  }
  return slot;
}

/** For what a cell would have to wait, or -1 if it would stay within the limits. */
template <int D>
int Budget<D>::FindSlot(const Removal<D>& removal) const
{
  for (int number = 0; number < Numbers; ++number)
  {
    const int change = removal.Change[number];
    if (change > 0 && change > this->GetRoom(number))
    {
      return Amounts * number + change - 1;
    }
  }
  return -1;
}

template <int D>
bool Budget<D>::Admit(const Candidate& candidate)
{
  Removal<D> removal = this->Rest.Examine(candidate.Cell);
  int wanting = this->FindSlot(removal);
  if (wanting >= 0 && !this->Rest.GetIsExact())
  {
    this->Rest.MakeExact();
    removal = this->Rest.Examine(candidate.Cell);
    wanting = this->FindSlot(removal);
  }
  if (wanting >= 0)
  {
    this->Rest.Keep(candidate.Cell, removal);
    return this->Defer(candidate, wanting);
  }
  if (this->Parts)
  {
    GluedParts::Labels labels;
    const int slot = this->FindPartsSlot(candidate.Cell, labels);
    if (slot >= 0)
    {
      return this->Defer(candidate, slot);
    }
    this->Parts->Carve(candidate.Cell, labels);
  }
  this->Rest.Carve(candidate.Cell, removal);
  this->Requeue(candidate.Cell, removal);
  return true;
}

/** Whether the cell was aside; it no longer is. */
template <int D>
bool Budget<D>::Release(int cell)
{
  const bool aside = this->IsDeferred(cell);
  this->SlotOf[cell] = -1;
  this->NumberDeferred -= aside;
  return aside;
}

template <int D>
void Budget<D>::Requeue(int cell, const Removal<D>& removal)
{
  std::vector<int>& cells = this->Requeued;
  cells.clear();
  if (this->NumberDeferred > 0)
  {
    this->Rest.FindTouched(cell, removal, cells);
    cells.erase(
      std::remove_if(cells.begin(), cells.end(), [this](int c) { return !this->Release(c); }),
      cells.end());
  }
}

template <int D>
const Candidate* Budget<D>::GetBest()
{
  const Candidate* best = nullptr;
  if (this->NumberDeferred == 0)
  {
    return nullptr;
  }
  for (int slot = 0; slot < NumberOfSlots; ++slot)
  {
    auto& queue = this->Waiting[slot];
    while (!queue.empty() && this->SlotOf[queue.top().Cell] != slot)
    {
      queue.pop(); // taken back since
    }
    if (!queue.empty() && slot % Amounts + 1 <= this->GetRoom(slot / Amounts) &&
      (!best || *best < queue.top()))
    {
      best = &queue.top();
      this->BestSlot = slot;
    }
  }
  return best;
}

template <int D>
void Budget<D>::PopBest()
{
  auto& queue = this->Waiting[this->BestSlot];
  this->Release(queue.top().Cell);
  queue.pop();
}

template class Budget<2>;
template class Budget<3>;

} // namespace carving
