// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Budget/GluedParts.h"

#include "Core/Mesh/DisjointSets.h"

#include <algorithm>
#include <limits>

namespace carving
{
namespace
{

constexpr int Gone = std::numeric_limits<int>::max(); ///< as if every search had been there

void Merge(std::array<int, 4>& labels, int a, int b)
{
  std::replace(labels.begin(), labels.end(), a, b);
}

} // namespace

GluedParts::GluedParts(const Decomposition<3>& mesh, const RemainingCells<3>& cells)
  : Cells(cells)
  , Nodes(mesh.Cells.size())
  , Touched(mesh.Surface.Points.size(), 0)
{
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  const auto stays = [&](int cell)
  { return cell >= 0 && this->Cells.States[cell] == CellState::Stays; };
  DisjointSets sets(numberOfCells);
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int neighbor = cells.GetNeighbor(cell, f);
      if (neighbor < cell && stays(cell) && stays(neighbor))
      {
        sets.Unite(cell, neighbor);
      }
      for (int corner = 0; corner < 4 && neighbor < 0; ++corner)
      {
        if (corner != f)
        {
          this->Touched[mesh.Cells[cell][corner]] = 1;
        }
      }
    }
  }
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    this->Nodes[cell].Block = stays(cell) ? sets.Find(cell) : -1;
  }
}

/** Whether others are all around an edge. */
bool GluedParts::IsBuried(int cell, int p, int q) const
{
  const auto& corners = this->Cells.Records[cell].Corners;
  if (!this->Touched[corners[p]] || !this->Touched[corners[q]])
  {
    return true;
  }
  EdgeTurn turns[] = { { this->Cells, cell, p, q, 0 }, { this->Cells, cell, p, q, 1 } };
  int at[] = { cell, cell };
  for (;;)
  {
    for (const int way : { 0, 1 })
    {
      at[way] = RemainingCells<3>::Past(turns[way].GetBehind());
      if (at[0] == at[1])
      {
        return true;
      }
      if (!this->Cells.IsLeft(at[way]))
      {
        return false;
      }
      turns[way].Enter(at[way]);
    }
  }
}

GluedParts::Labels GluedParts::Examine(int cell)
{
  Labels labels;
  for (int f = 0; f < 4; ++f)
  {
    labels[f] = this->Cells.IsLeft(this->Cells.GetNeighbor(cell, f)) ? f : -1;
  }
  for (int f = 1; f < 4; ++f)
  {
    for (int g = 0; g < f; ++g)
    {
      if (labels[f] < 0 || labels[g] < 0 || labels[f] == labels[g])
      {
        continue;
      }
      const auto [q, p] = OtherCorners(f, g);
      if (this->IsBuried(cell, p, q))
      {
        Merge(labels, labels[f], labels[g]);
      }
    }
  }
  return labels;
}

void GluedParts::Carve(int cell, const Labels& labels)
{
  this->Components += CountLabels(labels) - 1;
  this->Nodes[cell].ReachedBy = Gone;
  for (const int vertex : this->Cells.Records[cell].Corners)
  {
    this->Touched[vertex] = 1;
  }
}

int GluedParts::CountSides(int cell, const Labels& labels) const
{
  Labels sides = labels;
  for (int f = 0; f < 4; ++f)
  {
    sides[f] = sides[f] < 0 ? -1 : this->SideOf(cell, f);
  }
  return CountLabels(sides);
}

/** Whether two searches that have not met can both go on. */
bool GluedParts::AreSeveralOpen(const Labels& labels, const std::array<std::size_t, 4>& next) const
{
  int first = -1;
  for (int f = 0; f < 4; ++f)
  {
    const bool isOpen = next[f] < this->Reached[f].size();
    if (isOpen && first >= 0 && labels[f] != first)
    {
      return true;
    }
    first = isOpen ? labels[f] : first;
  }
  return false;
}

/** A search from face f comes to a cell, and with that to all that stays for good with it. */
void GluedParts::Reach(int cell, int from, int f, Labels& labels)
{
  const int now = 4 * this->Search;
  Node& node = this->Nodes[cell];
  if (node.ReachedBy >= now)
  {
    if (node.ReachedBy != Gone)
    {
      Merge(labels, labels[node.ReachedBy - now], labels[f]);
    }
    return;
  }
  node.ReachedBy = now + f;
  __builtin_prefetch(&this->Cells.Records[cell]); // for when the search goes on from here
  int entry = 0;
  while (node.Sides != 0 && this->Cells.GetNeighbor(cell, entry) != from)
  {
    ++entry;
  }
  this->Reached[f].push_back(4 * cell + entry);
  if (node.Block >= 0)
  {
    int& blockReachedBy = this->Nodes[node.Block].BlockReachedBy;
    if (blockReachedBy >= now)
    {
      Merge(labels, labels[blockReachedBy - now], labels[f]);
    }
    blockReachedBy = now + f;
  }
}

/** Searches from behind the faces of a tetrahedron, until all have met or only one can go on. */
void GluedParts::Join(int cell, Labels& labels)
{
  ++this->Search;
  std::array<std::size_t, 4> next = {};
  this->Nodes[cell].ReachedBy = Gone;
  for (int f = 0; f < 4; ++f)
  {
    this->Reached[f].clear();
    if (labels[f] >= 0)
    {
      this->Reach(this->Cells.GetNeighbor(cell, f), cell, f, labels);
    }
  }
  while (this->AreSeveralOpen(labels, next))
  {
    for (int f = 0; f < 4; ++f)
    {
      if (next[f] == this->Reached[f].size())
      {
        continue;
      }
      const int from = this->Reached[f][next[f]] / 4;
      const int side = this->SideOf(from, this->Reached[f][next[f]] % 4);
      ++next[f];
      for (int g = 0; g < 4; ++g)
      {
        const int to = this->Cells.GetNeighbor(from, g);
        if (to >= 0 && this->SideOf(from, g) == side)
        {
          this->Reach(to, from, f, labels);
        }
      }
    }
  }
  this->Nodes[cell].ReachedBy = -1;
}

void GluedParts::KeepAsBridge(int cell, const Labels& labels)
{
  this->Nodes[cell].Sides = 0;
  for (int f = 0; f < 4; ++f)
  {
    this->Nodes[cell].Sides |= static_cast<unsigned char>(std::max(0, labels[f]) << (2 * f));
  }
}

void GluedParts::MakeExact()
{
  this->IsExact = true;
  if (this->Components == 1)
  {
    return; // no less than that
  }
  const int numberOfCells = static_cast<int>(this->Cells.Records.size());
  DisjointSets sets(numberOfCells);
  this->Components = 0;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    const bool isFirstOfBlock = this->Nodes[cell].Block == cell;
    this->Components += isFirstOfBlock;
    if (this->Cells.States[cell] != CellState::Carvable)
    {
      continue;
    }
    ++this->Components;
    for (int f = 0; f < 4; ++f)
    {
      const int neighbor = this->Cells.GetNeighbor(cell, f);
      if (this->Cells.IsLeft(neighbor))
      {
        const int other =
          sets.Find(this->Nodes[neighbor].Block >= 0 ? this->Nodes[neighbor].Block : neighbor);
        const int own = sets.Find(cell);
        this->Components -= own != other;
        sets.Unite(own, other);
      }
    }
  }
}

} // namespace carving
