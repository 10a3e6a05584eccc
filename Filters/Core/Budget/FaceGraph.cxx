// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Budget/FaceGraph.h"

#include "Core/Mesh/DisjointSets.h"

namespace carving
{
namespace
{

/** Unites neighboring cells that satisfy `isNode`. Returns the number of sets of such cells. */
template <class Predicate>
int UniteNeighbors(const RemainingCells<3>& cells, DisjointSets& sets, Predicate&& isNode)
{
  int count = 0;
  for (int cell = 0; cell < static_cast<int>(cells.Records.size()); ++cell)
  {
    if (!isNode(cell))
    {
      continue;
    }
    ++count;
    for (int f = 0; f < 4; ++f)
    {
      const int neighbor = cells.GetNeighbor(cell, f);
      if (neighbor >= 0 && neighbor < cell && isNode(neighbor))
      {
        count -= sets.Find(cell) != sets.Find(neighbor);
        sets.Unite(cell, neighbor);
      }
    }
  }
  return count;
}

} // namespace

FaceGraph::FaceGraph(const RemainingCells<3>& cells)
  : Cells(cells)
  , Nodes(cells.Records.size())
{
  const auto isPermanent = [&](int cell) { return cells.States[cell] == CellState::Permanent; };
  DisjointSets sets(this->Nodes.size());
  this->Blocks.reserve(UniteNeighbors(cells, sets, isPermanent));
  for (int cell = 0; cell < static_cast<int>(this->Nodes.size()); ++cell)
  {
    if (isPermanent(cell))
    {
      const int first = sets.Find(cell);
      if (first == cell)
      {
        this->Nodes[cell].Block = static_cast<int>(this->Blocks.size());
        this->Blocks.push_back({});
      }
      this->Nodes[cell].Block =
        this->Nodes[first].Block; // the first cell of a set has the smallest index
    }
  }
}

int FaceGraph::CountComponents() const
{
  DisjointSets sets(this->Nodes.size());
  return UniteNeighbors(
    this->Cells, sets, [this](int cell) { return !this->Nodes[cell].IsCarved; });
}

} // namespace carving
