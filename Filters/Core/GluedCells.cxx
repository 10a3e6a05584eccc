// SPDX-License-Identifier: BSD-3-Clause
#include "GluedCells.h"

#include <algorithm>
#include <numeric>

namespace carving
{

GluedCells::GluedCells(const Decomposition<3>& mesh, const LeftCells<3>& cells)
  : Cells(cells)
  , Touched(mesh.Surface.Points.size(), 0)
  , Watched(mesh.Cells.size(), 0)
  , FirstWatcher(mesh.Surface.Points.size(), -1)
  , Next(4 * mesh.Cells.size() + mesh.Surface.Points.size())
  , Parts(cells)
{
  std::iota(this->Next.begin(), this->Next.end(), 0);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      for (int corner = 0; corner < 4 && cells.GetNeighbor(cell, f) < 0; ++corner)
      {
        if (corner != f)
        {
          this->Touched[mesh.Cells[cell][corner]] = 1;
        }
      }
    }
  }
}

/** What of the exterior is around an edge between two faces with others behind them; Nothing if none is. */
int GluedCells::FindExterior(int cell, int p, int q) const
{
  const auto& corners = this->Cells.Records[cell].Corners;
  if (!this->Touched[corners[p]] || !this->Touched[corners[q]])
  {
    return Nothing;
  }
  EdgeTurn turns[] = { { this->Cells, cell, p, q, 0 }, { this->Cells, cell, p, q, 1 } };
  int at[] = { cell, cell };
  for (;;)
  {
    for (const int way : { 0, 1 })
    {
      at[way] = LeftCells<3>::Past(turns[way].GetBehind());
      if (at[0] == at[1])
      {
        return Nothing; // all around
      }
      if (!this->Cells.IsLeft(at[way]))
      {
        return at[way];
      }
      turns[way].Enter(at[way]);
    }
  }
}

/** In the sets of the exterior: where a cell, or what is outside C0, is at a vertex. */
int GluedCells::GetCorner(int cell, int vertex) const
{
  return cell < 0 ? 4 * static_cast<int>(this->Cells.Records.size()) + vertex
                  : 4 * cell + CornerOf(this->Cells.Records[cell].Corners, vertex);
}

GluedRemoval GluedCells::Examine(int cell)
{
  this->Watched[cell] = 0;
  std::array<int, 4> behind;
  unsigned held = 0, touched = 0;
  for (int f = 0; f < 4; ++f)
  {
    behind[f] = this->Cells.GetNeighbor(cell, f);
    held |= static_cast<unsigned>(this->Cells.IsLeft(behind[f])) << f;
  }
  std::array<int, 6> exterior;
  for (int p = 0; p < 4; ++p)
  {
    for (int q = 0; q < p; ++q)
    {
      const auto [f, g] = OtherCorners(p, q);
      const bool isBetween = held >> f & held >> g & 1;
      const int found = isBetween ? this->FindExterior(cell, p, q) : behind[held >> f & 1 ? g : f];
      exterior[EdgeIndex(p, q)] = found;
      touched |= static_cast<unsigned>(isBetween && found != Nothing) << EdgeIndex(p, q);
    }
  }
  const GluedRemoval& apart = AssessApart(held, touched);
  std::array<unsigned, 4> closed = {};
  for (int corner = 0; corner < 4 && apart.HasSeveralGaps; ++corner)
  {
    closed[corner] = this->FindClosed(cell, corner, apart.Gaps[corner], exterior);
  }
  GluedRemoval removal =
    closed == std::array<unsigned, 4>() ? apart : Assess(held, touched, closed);
  removal.Exterior = exterior;
  return removal;
}

int GluedCells::FindRoot(int corner)
{
  while (this->Next[corner] != corner)
  {
    corner = this->Next[corner] = this->Next[this->Next[corner]];
  }
  return corner;
}

/**
 * Of the gaps at a corner of a tetrahedron, those that the exterior does not join to another one around the
 * vertex: there others close the gap once it has gone. Between two that are joined something falls off.
 */
unsigned GluedCells::FindClosed(
  int cell, int corner, unsigned gaps, const std::array<int, 6>& exterior)
{
  if ((gaps & (gaps - 1)) == 0)
  {
    return 0;
  }
  const int vertex = this->Cells.Records[cell].Corners[corner];
  std::array<int, 6> roots;
  for (int edge = 0; edge < 6; ++edge)
  {
    roots[edge] = gaps >> edge & 1 ? this->FindRoot(this->GetCorner(exterior[edge], vertex)) : -1;
  }
  unsigned closed = 0;
  for (int edge = 0; edge < 6; ++edge)
  {
    const bool isAlone = std::count(roots.begin(), roots.end(), roots[edge]) == 1;
    closed |= static_cast<unsigned>(roots[edge] >= 0 && isAlone) << edge;
  }
  return closed;
}

void GluedCells::JoinParts(int cell, GluedRemoval& removal)
{
  this->Parts.Join(cell, removal.Parts);
  removal.Components = CountLabels(removal.Parts) - 1;
}

void GluedCells::Carve(int cell, const GluedRemoval& removal)
{
  this->Components += removal.Components;
  this->Voids += removal.Voids;
  this->EulerCharacteristic += removal.EulerCharacteristic;
  this->Parts.Carve(cell);
  for (int p = 0; p < 4; ++p)
  {
    const int vertex = this->Cells.Records[cell].Corners[p];
    this->Touched[vertex] = 1;
    if (this->Merge(cell, p, removal))
    {
      this->NotifyAround(vertex);
    }
    for (int q = 0; q < p; ++q)
    {
      if (removal.Exterior[EdgeIndex(p, q)] == Nothing)
      {
        this->NotifyAround(cell, p, q);
      }
    }
    const int neighbor = this->Cells.GetNeighbor(cell, p);
    if (neighbor >= 0)
    {
      this->Notify(neighbor);
    }
  }
}

/**
 * Adds a corner of a cell that goes to the exterior around its vertex. Returns whether parts of that which
 * had been apart now hang together.
 */
bool GluedCells::Merge(int cell, int corner, const GluedRemoval& removal)
{
  const int own = 4 * cell + corner;
  bool merged = false;
  for (int edge = 0, gaps = removal.Gaps[corner]; gaps >> edge != 0; ++edge)
  {
    if ((gaps >> edge & 1) == 0)
    {
      continue;
    }
    const int other =
      this->GetCorner(removal.Exterior[edge], this->Cells.Records[cell].Corners[corner]);
    const int root = this->FindRoot(own);
    if (root == own)
    {
      // The first gap, mostly the only one: no need to go to the root, but the trees stay flat.
      this->Next[own] = this->Next[other];
      continue;
    }
    const int otherRoot = this->FindRoot(other);
    merged = merged || otherRoot != root;
    this->Next[root] = otherRoot;
  }
  return merged;
}

void GluedCells::Watch(int cell)
{
  this->Watched[cell] = 1;
  for (const int vertex : this->Cells.Records[cell].Corners)
  {
    int& first = this->FirstWatcher[vertex];
    this->Watchers.push_back({ cell, first });
    first = static_cast<int>(this->Watchers.size()) - 1;
  }
}

void GluedCells::Notify(int cell)
{
  if (this->Watched[cell])
  {
    this->Watched[cell] = 0;
    this->Changed.push_back(cell);
  }
}

void GluedCells::NotifyAround(int vertex)
{
  int watcher = std::exchange(this->FirstWatcher[vertex], -1);
  for (; watcher >= 0; watcher = this->Watchers[watcher].Next)
  {
    this->Notify(this->Watchers[watcher].Cell);
  }
}

/** All around an edge between two corners of a tetrahedron; the exterior has not touched it before. */
void GluedCells::NotifyAround(int cell, int p, int q)
{
  const auto& corners = this->Cells.Records[cell].Corners;
  if (this->FirstWatcher[corners[p]] < 0 || this->FirstWatcher[corners[q]] < 0)
  {
    return;
  }
  EdgeTurn turn(this->Cells, cell, p, q, 0);
  for (;;)
  {
    const int at = LeftCells<3>::Past(turn.GetBehind());
    if (at == cell)
    {
      return;
    }
    this->Notify(at);
    turn.Enter(at);
  }
}

} // namespace carving
