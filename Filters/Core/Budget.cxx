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
      this->Glued = std::make_unique<GluedCells>(mesh, this->Rest.GetStates());
    }
  }
}

template <int D>
int Budget<D>::GetRoom(int number) const
{
  return this->Limits[number] - this->Rest.GetBettiNumbers()[number];
}

template <int D>
bool Budget<D>::PutAside(const Candidate& candidate, int slot)
{
  this->Waiting[slot].push(candidate);
  this->SlotOf[candidate.Cell] = static_cast<signed char>(slot);
  ++this->NumberAside;
  return false;
}

/** Whether the surface without the cell, once it is cut, would stay within the limits. */
template <int D>
bool Budget<D>::IsGluedWithin(int cell, GluedCells::Removal& removal)
{
  removal = this->Glued->Examine(cell);
  const auto isWithin = [&](const GluedCells::Removal& r)
  {
    return this->Glued->GetComponents() + r.Components <= this->Limits[0] &&
      this->Glued->GetTunnels(r) <= this->Limits[1];
  };
  if (isWithin(removal) || removal.Components <= 0)
  {
    this->MayBeLess = this->MayBeLess || removal.Components > 0;
    return isWithin(removal);
  }
  if (this->Glued->GetTunnels() > 0) // else nothing else joins the parts
  {
    GluedCells::Removal least = removal;
    least.Components = this->Glued->CountSides(cell, removal) - 1;
    if (!isWithin(least))
    {
      return false;
    }
    this->Glued->JoinParts(cell, removal);
  }
  if (removal.Components > 0 && !isWithin(removal))
  {
    this->Glued->KeepAsBridge(cell, removal);
  }
  return isWithin(removal);
}

template <int D>
bool Budget<D>::Admit(const Candidate& candidate)
{
  const Removal<D> removal = this->Rest.Examine(candidate.Cell);
  for (int number = 0; number < Numbers; ++number)
  {
    const int change = removal.Change[number];
    if (change > 0 && change > this->GetRoom(number))
    {
      this->Rest.Keep(candidate.Cell, removal);
      return this->PutAside(candidate, Amounts * number + change - 1);
    }
  }
  if (this->Glued)
  {
    GluedCells::Removal cut;
    if (!this->IsGluedWithin(candidate.Cell, cut))
    {
      return this->PutAside(candidate, LastSlot);
    }
    this->Glued->Carve(candidate.Cell, cut);
  }
  this->Rest.Carve(candidate.Cell, removal);
  this->TakeBack(candidate.Cell, removal);
  this->HasCarved = true;
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
const Candidate* Budget<D>::GetBest()
{
  const Candidate* best = nullptr;
  for (int slot = 0; slot<Amounts * Numbers&& this->NumberAside> 0; ++slot)
  {
    auto& queue = this->Waiting[slot];
    if (slot % Amounts >= this->GetRoom(slot / Amounts))
    {
      continue;
    }
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
  auto& queue = this->Waiting[LastSlot];
  if (!this->HasCarved || queue.empty())
  {
    return cells;
  }
  this->HasCarved = false;
  const int before = this->Glued->GetComponents();
  if (this->MayBeLess)
  {
    this->Glued->CountComponents();
    this->MayBeLess = false;
  }
  const bool hasRoom = this->Glued->GetComponents() < before;
  std::vector<Candidate> others;
  for (; !queue.empty(); queue.pop())
  {
    const int cell = queue.top().Cell;
    if (this->SlotOf[cell] == LastSlot)
    {
      if (hasRoom || this->Glued->HasChanged(cell))
      {
        this->ComesBack(cell);
        cells.push_back(cell);
      }
      else
      {
        others.push_back(queue.top());
      }
    }
  }
  queue = std::priority_queue<Candidate>({}, std::move(others));
  return cells;
}

template class Budget<2>;
template class Budget<3>;

} // namespace carving
