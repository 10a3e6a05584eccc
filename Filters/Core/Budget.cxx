// SPDX-License-Identifier: BSD-3-Clause
#include "Budget.h"

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
    if (limits[0] >= 0 || limits[1] >= 0)
    {
      this->Glued = std::make_unique<GluedCells>(mesh, this->Rest.GetCells());
    }
  }
}

template <int D>
int Budget<D>::GetRoom(int number) const
{
  return this->Limits[number] - this->Rest.GetBettiNumbers()[number];
}

template <int D>
int Budget<D>::GetGluedRoom(int number) const
{
  return this->Limits[number] -
    (number == 0 ? this->Glued->GetComponents() : this->Glued->GetTunnels());
}

template <int D>
bool Budget<D>::PutAside(const Candidate& candidate, int slot)
{
  this->Waiting[slot].push(candidate);
  if (slot >= GluedSlots)
  {
    this->Glued->Watch(candidate.Cell);
  }
  this->SlotOf[candidate.Cell] = static_cast<signed char>(slot);
  ++this->NumberAside;
  return false;
}

/**
 * For what a cell would have to wait if the surface is cut without it, or -1 if it would stay within the
 * limits.
 */
template <int D>
int Budget<D>::FindGluedSlot(int cell, GluedRemoval& removal)
{
  removal = this->Glued->Examine(cell);
  const auto findSlot = [&](const GluedRemoval& r)
  {
    const int first = r.Components > this->GetGluedRoom(0) ? GluedSlots
      : r.GetTunnels() > this->GetGluedRoom(1)             ? GluedSlots + GluedAmounts
                                                           : -1;
    const int amount = first == GluedSlots ? r.Components : r.GetTunnels();
    return first < 0 ? -1 : first + std::max(amount, 1) - 1;
  };
  const int slot = findSlot(removal);
  if (slot < 0 || removal.Components <= 0)
  {
    this->MayBeLess = this->MayBeLess || removal.Components > 0;
    return slot;
  }
  if (this->Glued->GetTunnels() > 0) // else nothing else joins the parts
  {
    GluedRemoval least = removal;
    least.Components = this->Glued->GetParts().CountSides(cell, removal.Parts) - 1;
    if (const int leastSlot = findSlot(least); leastSlot >= 0)
    {
      return leastSlot;
    }
    this->Glued->JoinParts(cell, removal);
  }
  const int exactSlot = findSlot(removal);
  if (removal.Components > 0 && exactSlot >= 0)
  {
    this->Glued->GetParts().KeepAsBridge(cell, removal.Parts);
  }
  return exactSlot;
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
    return this->PutAside(candidate, wanting);
  }
  if (this->Glued)
  {
    GluedRemoval cut;
    const int slot = this->FindGluedSlot(candidate.Cell, cut);
    if (slot >= 0)
    {
      return this->PutAside(candidate, slot);
    }
    this->Glued->Carve(candidate.Cell, cut);
  }
  this->Rest.Carve(candidate.Cell, removal);
  this->TakeBack(candidate.Cell, removal);
  return true;
}

/** Whether the cell was aside; it no longer is. */
template <int D>
bool Budget<D>::ComesBack(int cell)
{
  const bool aside = this->IsAside(cell);
  this->SlotOf[cell] = -1;
  this->NumberAside -= aside;
  return aside;
}

template <int D>
void Budget<D>::TakeBack(int cell, const Removal<D>& removal)
{
  std::vector<int>& cells = this->TakenBack;
  cells.clear();
  if (this->NumberAside > 0)
  {
    this->Rest.FindTouched(cell, removal, cells);
    cells.erase(
      std::remove_if(cells.begin(), cells.end(), [this](int c) { return !this->ComesBack(c); }),
      cells.end());
  }
}

template <int D>
int Budget<D>::GetRoomFor(int slot) const
{
  return slot < GluedSlots ? this->GetRoom(slot / Amounts)
                           : this->GetGluedRoom((slot - GluedSlots) / GluedAmounts);
}

/** The first of the cells that wait in some slots for no more than there is room for, or nullptr. */
template <int D>
const Candidate* Budget<D>::FindBest(int firstSlot, int lastSlot)
{
  const Candidate* best = nullptr;
  if (this->NumberAside == 0)
  {
    return nullptr;
  }
  for (int slot = firstSlot; slot < lastSlot; ++slot)
  {
    const int amount =
      slot < GluedSlots ? slot % Amounts + 1 : (slot - GluedSlots) % GluedAmounts + 1;
    if (amount > this->GetRoomFor(slot))
    {
      continue;
    }
    auto& queue = this->Waiting[slot];
    while (!queue.empty() && this->SlotOf[queue.top().Cell] != slot)
    {
      queue.pop(); // taken back since
    }
    if (!queue.empty() && (!best || *best < queue.top()))
    {
      best = &queue.top();
      this->BestSlot = slot;
    }
  }
  return best;
}

template <int D>
const Candidate* Budget<D>::GetBest()
{
  return this->FindBest(0, GluedSlots);
}

template <int D>
void Budget<D>::PopBest()
{
  auto& queue = this->Waiting[this->BestSlot];
  this->ComesBack(queue.top().Cell);
  queue.pop();
}

template <int D>
std::vector<int> Budget<D>::TakeBackLast()
{
  std::vector<int> cells;
  if (!this->Glued)
  {
    return cells;
  }
  for (const int cell : this->Glued->TakeChanged())
  {
    if (this->SlotOf[cell] >= GluedSlots)
    {
      this->ComesBack(cell);
      cells.push_back(cell);
    }
  }
  if (cells.empty() && this->MayBeLess)
  {
    this->Glued->CountComponents();
    this->MayBeLess = false;
  }
  const Candidate* best = cells.empty() ? this->FindBest(GluedSlots, NumberOfSlots) : nullptr;
  if (best)
  {
    cells.push_back(best->Cell);
    this->PopBest();
  }
  return cells;
}

template class Budget<2>;
template class Budget<3>;

} // namespace carving
