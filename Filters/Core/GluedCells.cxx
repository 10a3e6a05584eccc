// SPDX-License-Identifier: BSD-3-Clause
#include "GluedCells.h"

#include <algorithm>

namespace carving
{
namespace
{

void Unite(std::array<int, 4>& labels, int a, int b)
{
  std::replace(labels.begin(), labels.end(), a, b);
}

} // namespace

/** Unites those cells that share faces with each other. */
template <class Predicate>
DisjointSets GluedCells::Glue(Predicate&& isOne) const
{
  DisjointSets sets(this->Mesh.Cells.size());
  for (int cell = 0; cell < static_cast<int>(this->Mesh.Cells.size()); ++cell)
  {
    for (const int neighbor : this->Mesh.Neighbors[cell])
    {
      if (neighbor >= 0 && neighbor < cell && isOne(neighbor) && isOne(cell))
      {
        sets.Unite(cell, neighbor);
      }
    }
  }
  return sets;
}

GluedCells::GluedCells(const Decomposition<3>& mesh, const std::vector<CellState>& states)
  : Mesh(mesh)
  , States(states)
  , Records(mesh.Cells.size())
  , Touched(mesh.Surface.Points.size(), -1)
  , LookedAt(mesh.Cells.size(), -1)
  , Sides(mesh.Cells.size(), 0)
  , ReachedBy(mesh.Cells.size(), -1)
  , Block(mesh.Cells.size(), -1)
  , BlockReachedBy(mesh.Cells.size(), -1)
{
  DisjointSets sets = this->Glue([&](int cell) { return states[cell] == CellState::Stays; });
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    this->Records[cell] = { mesh.Cells[cell], mesh.Neighbors[cell] };
    if (states[cell] == CellState::Stays)
    {
      this->Block[cell] = sets.Find(static_cast<int>(cell));
    }
    for (int f = 0; f < 4; ++f)
    {
      for (int corner = 0; corner < 4 && mesh.Neighbors[cell][f] < 0; ++corner)
      {
        if (corner != f)
        {
          this->Touched[mesh.Cells[cell][corner]] = 0;
        }
      }
    }
  }
}

/** Whether the exterior is somewhere around the edge between two corners of a tetrahedron. */
bool GluedCells::IsTouched(int cell, int p, int q) const
{
  const Record& start = this->Records[cell];
  const int edge[] = { start.Corners[p], start.Corners[q] };
  if (this->Touched[edge[0]] < 0 || this->Touched[edge[1]] < 0)
  {
    return false;
  }
  const std::array<int, 2> others = OtherCorners(p, q);
  int at = cell, through = others[0], ahead = start.Corners[others[1]];
  for (;;)
  {
    at = this->Records[at].Behind[through];
    if (at == cell || at < 0)
    {
      return at < 0;
    }
    const auto& corners = this->Records[at].Corners;
    const int behind = ahead;
    for (int corner = 0; corner < 4; ++corner)
    {
      const int vertex = corners[corner];
      if (vertex == behind)
      {
        through = corner;
      }
      else if (vertex != edge[0] && vertex != edge[1])
      {
        ahead = vertex;
      }
    }
  }
}

bool GluedCells::HasChanged(int cell) const
{
  const auto& corners = this->Mesh.Cells[cell];
  return std::any_of(corners.begin(), corners.end(),
    [&](int vertex) { return this->Touched[vertex] > this->LookedAt[cell]; });
}

GluedCells::Removal GluedCells::Examine(int cell)
{
  this->LookedAt[cell] = this->Time;
  Labels labels;
  int held = 0;
  for (int f = 0; f < 4; ++f)
  {
    const bool isHeld = this->Records[cell].Behind[f] >= 0;
    labels[f] = isHeld ? f : -1;
    held += isHeld;
  }
  if (held < 2)
  {
    return held == 0 ? Removal{ -1, 0, -1, labels } : Removal{ 0, 0, 0, labels };
  }
  const Labels faces = labels;
  std::array<std::array<int, 2>, 6> touched; // pairs of faces
  int numberOfTouched = 0;
  for (int f = 0; f < 4; ++f)
  {
    for (int g = 0; g < f; ++g)
    {
      if (faces[f] >= 0 && faces[g] >= 0)
      {
        const auto [p, q] = OtherCorners(f, g);
        if (this->IsTouched(cell, p, q))
        {
          touched[numberOfTouched++] = { f, g };
        }
        else
        {
          Unite(labels, labels[f], labels[g]);
        }
      }
    }
  }
  if (numberOfTouched == 0)
  {
    const int voids = held == 4 ? 1 : 0;
    return { 0, voids, voids, labels };
  }
  // The other edges, faces and the tetrahedron itself leave the characteristic as it is.
  Removal removal = {};
  removal.EulerCharacteristic = (held == 4) - numberOfTouched;
  for (int corner = 0; corner < 4; ++corner)
  {
    Labels around = faces;
    around[corner] = -1;
    for (int f = 0; f < 4; ++f)
    {
      for (int g = 0; g < f; ++g)
      {
        const bool apart = std::find(touched.begin(), touched.begin() + numberOfTouched,
                             std::array<int, 2>{ f, g }) != touched.begin() + numberOfTouched;
        if (around[f] >= 0 && around[g] >= 0 && !apart)
        {
          Unite(around, around[f], around[g]);
        }
      }
    }
    if (CountLabels(around) > 1)
    {
      this->Join(cell, this->Mesh.Cells[cell][corner], around);
      removal.EulerCharacteristic += CountLabels(around) - 1;
    }
    for (int f = 0; f < 4; ++f)
    {
      for (int g = 0; g < f; ++g)
      {
        if (around[f] >= 0 && around[f] == around[g])
        {
          Unite(labels, labels[f], labels[g]);
        }
      }
    }
  }
  removal.Components = CountLabels(labels) - 1;
  removal.Parts = labels;
  return removal;
}

int GluedCells::CountSides(int cell, const Removal& removal) const
{
  Labels sides = removal.Parts;
  for (int f = 0; f < 4; ++f)
  {
    sides[f] = sides[f] < 0 ? -1 : this->SideOf(cell, f);
  }
  return CountLabels(sides);
}

void GluedCells::JoinParts(int cell, Removal& removal)
{
  this->Join(cell, -1, removal.Parts);
  removal.Components = CountLabels(removal.Parts) - 1;
}

/** The search from face f comes to a cell, and with that to all that stays for good with it. */
void GluedCells::Reach(int cell, int from, int f, Labels& labels, bool everywhere)
{
  const int now = 4 * this->Search;
  int& reachedBy = this->ReachedBy[cell];
  if (reachedBy >= now)
  {
    Unite(labels, labels[reachedBy - now], labels[f]);
    return;
  }
  reachedBy = now + f;
  __builtin_prefetch(&this->Records[cell]); // for when the search goes on from here
  int entry = 0;
  while (everywhere && this->Sides[cell] != 0 && this->Records[cell].Behind[entry] != from)
  {
    ++entry;
  }
  this->Reached[f].push_back(4 * cell + entry);
  if (everywhere && this->Block[cell] >= 0)
  {
    int& blockReachedBy = this->BlockReachedBy[this->Block[cell]];
    if (blockReachedBy >= now)
    {
      Unite(labels, labels[blockReachedBy - now], labels[f]);
    }
    blockReachedBy = now + f;
  }
}

/**
 * Searches from behind the faces of a tetrahedron through the others, with a vertex through those around
 * that alone, in lockstep until all have met or only one can go on.
 */
void GluedCells::Join(int cell, int vertex, Labels& labels)
{
  ++this->Search;
  std::array<std::size_t, 4> next = {};
  for (int f = 0; f < 4; ++f)
  {
    this->Reached[f].clear();
    if (labels[f] >= 0)
    {
      this->Reach(this->Records[cell].Behind[f], cell, f, labels, vertex < 0);
    }
  }
  const auto isOpen = [&](int f) { return next[f] < this->Reached[f].size(); };
  const auto areSeveralOpen = [&]
  {
    int first = -1;
    for (int f = 0; f < 4; ++f)
    {
      if (isOpen(f) && first >= 0 && labels[f] != first)
      {
        return true;
      }
      first = isOpen(f) ? labels[f] : first;
    }
    return false;
  };
  while (areSeveralOpen())
  {
    for (int f = 0; f < 4; ++f)
    {
      if (!isOpen(f))
      {
        continue;
      }
      const int from = this->Reached[f][next[f]] / 4;
      const int side = this->SideOf(from, this->Reached[f][next[f]] % 4);
      const Record& record = this->Records[from];
      ++next[f];
      for (int g = 0; g < 4; ++g)
      {
        const int to = record.Behind[g];
        if (to < 0 || to == cell ||
          (vertex >= 0 ? record.Corners[g] == vertex : this->SideOf(from, g) != side))
        {
          continue;
        }
        this->Reach(to, from, f, labels, vertex < 0);
      }
    }
  }
}

void GluedCells::KeepAsBridge(int cell, const Removal& removal)
{
  this->Sides[cell] = 0;
  for (int f = 0; f < 4; ++f)
  {
    this->Sides[cell] |= static_cast<unsigned char>(std::max(0, removal.Parts[f]) << (2 * f));
  }
}

void GluedCells::Carve(int cell, const Removal& removal)
{
  this->Components += removal.Components;
  this->Voids += removal.Voids;
  this->EulerCharacteristic += removal.EulerCharacteristic;
  ++this->Time;
  for (const int vertex : this->Mesh.Cells[cell])
  {
    this->Touched[vertex] = this->Time;
  }
  for (const int neighbor : this->Records[cell].Behind)
  {
    if (neighbor >= 0)
    {
      auto& behind = this->Records[neighbor].Behind;
      std::replace(behind.begin(), behind.end(), cell, -1);
    }
  }
}

void GluedCells::CountComponents()
{
  const auto isLeft = [this](int cell) { return this->States[cell] != CellState::Carved; };
  DisjointSets sets = this->Glue(isLeft);
  this->Components = 0;
  for (int cell = 0; cell < static_cast<int>(this->Mesh.Cells.size()); ++cell)
  {
    this->Components += isLeft(cell) && sets.Find(cell) == cell;
  }
}

} // namespace carving
