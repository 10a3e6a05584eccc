// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Budget/Budget.h"

#include <algorithm>
#include <limits>

namespace carving
{

template <int D>
Budget<D>::Budget(
  const Decomposition<D>& mesh, const std::vector<CellState>& states, const BettiNumbers& limits)
  : Complex(mesh, states)
  , Limits(limits)
  , ShortageOf(mesh.Cells.size())
{
  this->Limits[0] = limits[0] == 0 ? 1 : limits[0]; // C0 has one component
  for (int& limit : this->Limits)
  {
    limit = limit < 0 ? std::numeric_limits<int>::max() : limit;
  }
  if constexpr (D == 3)
  {
    if (limits[0] >= 0)
    {
      this->Glued = std::make_unique<GluedParts>(mesh, this->Complex.GetCells());
    }
  }
}

/** How much a number may grow. */
template <int D>
int Budget<D>::GetRoom(int number) const
{
  return number == GluedComponents ? this->Limits[0] - this->Glued->GetComponents()
                                   : this->Limits[number] - this->Complex.GetBettiNumbers()[number];
}

template <int D>
typename Budget<D>::Shortage Budget<D>::FindShortage(int number, int change) const
{
  if (change > 0 && change > this->GetRoom(number))
  {
    return { static_cast<signed char>(number), static_cast<signed char>(change) };
  }
  return {};
}

/** The shortage of the first Betti number for which there is not enough room. */
template <int D>
typename Budget<D>::Shortage Budget<D>::FindShortage(const RemovalEffect<D>& effect) const
{
  Shortage shortage;
  for (int number = 0; number < NumberOfBettiNumbers && shortage.Amount == 0; ++number)
  {
    shortage = this->FindShortage(number, effect.Change[number]);
  }
  return shortage;
}

/** Examines the removal of a cell from K: exactly, if by upper bounds it would exceed a limit. */
template <int D>
typename Budget<D>::Shortage Budget<D>::ExamineComplex(int cell, RemovalEffect<D>& effect)
{
  effect = this->Complex.Examine(cell);
  Shortage shortage = this->FindShortage(effect);
  if (shortage.Amount > 0 && !this->Complex.IsExact())
  {
    this->Complex.MakeExact();
    effect = this->Complex.Examine(cell);
    shortage = this->FindShortage(effect);
  }
  if (shortage.Amount > 0)
  {
    this->Complex.Keep(cell, effect);
  }
  return shortage;
}

/** The same for N. */
template <int D>
typename Budget<D>::Shortage Budget<D>::ExamineGlued(int cell, Labels<4>& labels)
{
  const auto examine = [&]
  {
    labels = this->Glued->Examine(cell);
    return this->FindShortage(GluedComponents, CountLabels(labels) - 1);
  };
  Shortage shortage = examine();
  if (shortage.Amount > 0 && !this->Glued->IsExact())
  {
    this->Glued->MakeExact();
    shortage = examine();
  }
  if (shortage.Amount > 0)
  {
    this->Glued->Keep(cell, labels);
  }
  return shortage;
}

template <int D>
bool Budget<D>::Admit(const Candidate& candidate)
{
  const int cell = candidate.Cell;
  RemovalEffect<D> effect;
  Labels<4> labels;
  Shortage shortage = this->ExamineComplex(cell, effect);
  if (shortage.Amount == 0 && this->Glued)
  {
    shortage = this->ExamineGlued(cell, labels);
  }
  if (shortage.Amount > 0)
  {
    this->Defer(candidate, shortage);
    return false;
  }
  if (this->Glued)
  {
    this->Glued->Carve(cell, labels);
  }
  this->Complex.Carve(cell, effect);
  this->Requeue(cell, effect);
  return true;
}

template <int D>
void Budget<D>::Defer(const Candidate& candidate, Shortage shortage)
{
  this->Waiting[shortage.Number][shortage.Amount - 1].push(candidate);
  this->ShortageOf[candidate.Cell] = shortage;
  ++this->NumberDeferred;
}

/** Ends the deferral of a cell. Returns whether the cell was deferred. */
template <int D>
bool Budget<D>::Release(int cell)
{
  const bool wasDeferred = this->IsDeferred(cell);
  this->ShortageOf[cell] = {};
  this->NumberDeferred -= wasDeferred;
  return wasDeferred;
}

template <int D>
void Budget<D>::Requeue(int cell, const RemovalEffect<D>& effect)
{
  std::vector<int>& cells = this->Requeued;
  cells.clear();
  if (this->NumberDeferred > 0)
  {
    this->Complex.FindAffected(cell, effect, cells);
    cells.erase(
      std::remove_if(cells.begin(), cells.end(), [this](int c) { return !this->Release(c); }),
      cells.end());
  }
}

template <int D>
const Candidate* Budget<D>::GetBest()
{
  if (this->NumberDeferred == 0)
  {
    return nullptr;
  }
  const Candidate* best = nullptr;
  for (int number = 0; number < NumberOfLimits; ++number)
  {
    for (int amount = 1; amount <= LargestAmount; ++amount)
    {
      auto& queue = this->Waiting[number][amount - 1];
      const auto isStale = [&](const Candidate& candidate)
      {
        const Shortage& shortage = this->ShortageOf[candidate.Cell];
        return shortage.Number != number || shortage.Amount != amount;
      };
      while (!queue.empty() && isStale(queue.top()))
      {
        queue.pop();
      }
      if (!queue.empty() && amount <= this->GetRoom(number) && (!best || *best < queue.top()))
      {
        best = &queue.top();
        this->BestQueue = &queue;
      }
    }
  }
  return best;
}

template <int D>
void Budget<D>::PopBest()
{
  this->Release(this->BestQueue->top().Cell);
  this->BestQueue->pop();
}

template class Budget<2>;
template class Budget<3>;

} // namespace carving
