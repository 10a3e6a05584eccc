// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/CollapseQueue.h"

#include <algorithm>
#include <limits>

namespace carving::helper
{

CollapseQueue::CollapseQueue(const SurfaceMesh& surface)
  : Surface(surface)
  , Stamps(surface.num_edges(), 0)
  , IsQueued(surface.num_edges(), 0)
{
}

void CollapseQueue::Push(Edge edge, double cost, const std::optional<Point>& position)
{
  this->DropOutdated();
  this->IsQueued[edge] = 1;
  this->Heap.push_back({ cost, edge, ++this->Stamps[edge] });
  std::push_heap(this->Heap.begin(), this->Heap.end());
  if (position)
  {
    this->Positions[edge] = *position;
  }
  else
  {
    this->Positions.erase(edge);
  }
}

std::optional<CollapseQueue::Edge> CollapseQueue::Pop()
{
  this->DropOutdatedTop();
  if (this->Heap.empty())
  {
    return std::nullopt;
  }
  const Edge edge(this->Heap.front().Index);
  this->IsQueued[edge] = 0;
  this->PopCandidate();
  return edge;
}

double CollapseQueue::GetLeastCost()
{
  this->DropOutdatedTop();
  return this->Heap.empty() ? std::numeric_limits<double>::infinity() : this->Heap.front().Cost;
}

std::optional<Point> CollapseQueue::GetPosition(Edge edge) const
{
  const auto found = this->Positions.find(edge);
  return found != this->Positions.end() ? std::optional<Point>(found->second) : std::nullopt;
}

bool CollapseQueue::IsCurrent(const Candidate& candidate) const
{
  return !this->Surface.is_removed(Edge(candidate.Index)) &&
    candidate.Stamp == this->Stamps[candidate.Index];
}

void CollapseQueue::PopCandidate()
{
  std::pop_heap(this->Heap.begin(), this->Heap.end());
  this->Heap.pop_back();
}

void CollapseQueue::DropOutdatedTop()
{
  while (!this->Heap.empty() && !this->IsCurrent(this->Heap.front()))
  {
    this->PopCandidate();
  }
}

/** Keeps the heap from growing beyond twice the number of edges. */
void CollapseQueue::DropOutdated()
{
  if (this->Heap.size() > 2 * this->Surface.number_of_edges())
  {
    this->Heap.erase(std::remove_if(this->Heap.begin(), this->Heap.end(),
                       [this](const Candidate& candidate) { return !this->IsCurrent(candidate); }),
      this->Heap.end());
    std::make_heap(this->Heap.begin(), this->Heap.end());
  }
}

} // namespace carving::helper
