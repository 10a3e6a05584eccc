// SPDX-License-Identifier: BSD-3-Clause
#include "GluedParts.h"

#include "DisjointSets.h"

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

GluedParts::GluedParts(const LeftCells<3>& cells)
  : Cells(cells)
{
}

/** Most carvings need no search at all, or not for long. */
void GluedParts::Prepare()
{
  if (!this->Nodes.empty())
  {
    return;
  }
  const int numberOfCells = static_cast<int>(this->Cells.States.size());
  const auto stays = [&](int cell)
  { return cell >= 0 && this->Cells.States[cell] == CellState::Stays; };
  DisjointSets sets(numberOfCells);
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    for (int f = 0; f < 4 && stays(cell); ++f)
    {
      const int neighbor = this->Cells.GetNeighbor(cell, f);
      if (neighbor < cell && stays(neighbor))
      {
        sets.Unite(cell, neighbor);
      }
    }
  }
  this->Nodes.resize(numberOfCells);
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    Node& node = this->Nodes[cell];
    node.ReachedBy = this->Cells.IsLeft(cell) ? -1 : Gone;
    node.Block = stays(cell) ? sets.Find(cell) : -1;
    this->NumberOfBlocks += node.Block == cell;
  }
}

void GluedParts::Carve(int cell)
{
  if (!this->Nodes.empty())
  {
    this->Nodes[cell].ReachedBy = Gone;
  }
}

int GluedParts::CountSides(int cell, const Labels& labels) const
{
  if (this->Nodes.empty())
  {
    return std::min(1, CountLabels(labels)); // none is
  }
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
  this->Prepare();
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
  this->Prepare();
  this->Nodes[cell].Sides = 0;
  for (int f = 0; f < 4; ++f)
  {
    this->Nodes[cell].Sides |= static_cast<unsigned char>(std::max(0, labels[f]) << (2 * f));
  }
}

int GluedParts::CountComponents()
{
  this->Prepare();
  const int numberOfCells = static_cast<int>(this->Cells.Records.size());
  DisjointSets sets(numberOfCells);
  int components = this->NumberOfBlocks;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    if (this->Cells.States[cell] != CellState::Carvable)
    {
      continue;
    }
    ++components;
    for (int f = 0; f < 4; ++f)
    {
      const int neighbor = this->Cells.GetNeighbor(cell, f);
      if (this->Cells.IsLeft(neighbor))
      {
        const int other =
          sets.Find(this->Nodes[neighbor].Block >= 0 ? this->Nodes[neighbor].Block : neighbor);
        const int own = sets.Find(cell);
        components -= own != other;
        sets.Unite(own, other);
      }
    }
  }
  return components;
}

} // namespace carving
