// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Budget/CarvedComplex.h"

#include <algorithm>

namespace carving
{
namespace
{

/**
 * Whether something else than the tetrahedron, and than its faces, holds the edge between two corners.
 * Turns both ways at once, so that it costs as much as the shorter one.
 */
bool IsEdgeHeld(const RemainingCells<3>& cells, int cell, int p, int q)
{
  EdgeTurn turns[] = { { cells, cell, p, q, 0 }, { cells, cell, p, q, 1 } };
  int at[] = { cell, cell };
  for (;;)
  {
    for (const int way : { 0, 1 })
    {
      if (at[way] == Outside)
      {
        continue;
      }
      at[way] = turns[way].GetBehind();
      if (at[0] == at[1]) // all around, or both are outside C0
      {
        return false;
      }
      if (cells.IsFacet(at[way]) || cells.IsLeft(at[way]))
      {
        return at[way] != cell;
      }
      if (at[way] != Outside)
      {
        turns[way].Enter(at[way]);
      }
    }
  }
}

/** The only cell besides the one carved last that holds the edge between two corners of that; else -1. */
int FindOnlyHolder(const RemainingCells<3>& cells, int cell, int p, int q)
{
  int only = -1;
  for (const int way : { 0, 1 })
  {
    EdgeTurn turn(cells, cell, p, q, way);
    int holder = turn.GetBehind();
    while (holder >= 0 && holder != cell && !cells.IsLeft(holder))
    {
      turn.Enter(holder);
      holder = turn.GetBehind();
    }
    if (cells.IsFacet(holder) || holder == cell || (only >= 0 && holder >= 0 && holder != only))
    {
      return -1;
    }
    only = std::max(only, holder);
  }
  return only;
}

} // namespace

template <int D>
CarvedComplex<D>::CarvedComplex(const Decomposition<D>& mesh, const std::vector<CellState>& states)
  : Cells(mesh, states)
  , Rest(mesh, this->Cells.States)
  , Around(mesh.Surface.Points.size(), { 0, 0 })
{
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (const int vertex : mesh.Cells[cell])
    {
      auto& [count, combined] = this->Around[vertex];
      count = states[cell] == CellState::Stays || count < 0 ? -1 : count + 1;
      combined ^= cell;
    }
  }
  for (const auto& facet : mesh.Surface.Facets)
  {
    for (const int vertex : facet)
    {
      this->Around[vertex][0] = -1;
    }
  }
}

/** Whether something else than the cell holds its face opposite to corner f. */
template <int D>
bool CarvedComplex<D>::IsFaceHeld(int cell, int f) const
{
  const int behind = this->Cells.Records[cell].Behind[f];
  return this->Cells.IsFacet(behind) || this->Cells.IsLeft(behind);
}

template <int D>
Removal<D> CarvedComplex<D>::Examine(int cell)
{
  Removal<D> removal;
  std::array<bool, D + 1> faceHeld;
  int faces = 0;
  for (int f = 0; f <= D; ++f)
  {
    this->Fetch(std::max(this->Cells.GetNeighbor(cell, f), 0)); // most turns begin there
    faceHeld[f] = this->IsFaceHeld(cell, f);
    faces += faceHeld[f];
  }
  if (faces >= D) // a sphere, or but for one face, which changes nothing
  {
    removal.Change[D - 1] = faces - D;
    return removal;
  }
  if constexpr (D == 3)
  {
    if (faces == 2) // they share an edge, and the rest of the boundary another one
    {
      const int f =
        static_cast<int>(std::find(faceHeld.begin(), faceHeld.end(), false) - faceHeld.begin());
      const int g = static_cast<int>(
        std::find(faceHeld.begin() + f + 1, faceHeld.end(), false) - faceHeld.begin());
      const auto [q, p] = OtherCorners(f, g);
      if (IsEdgeHeld(this->Cells, cell, p, q))
      {
        removal.Change[1] = 1;
        removal.HeldEdges[EdgeIndex(p, q)] = true;
      }
      return removal;
    }
  }
  auto& labels = removal.Components;
  std::array<bool, D + 1> vertexHeld;
  for (int corner = 0; corner <= D; ++corner)
  {
    const int count = this->Around[this->Cells.Records[cell].Corners[corner]][0];
    vertexHeld[corner] = count < 0 || count > 1;
    labels[corner] = vertexHeld[corner] ? corner : -1;
  }
  int edges = 0;
  for (int p = 0; p <= D; ++p)
  {
    for (int q = 0; q < p; ++q)
    {
      bool held = false;
      if constexpr (D == 2)
      {
        held = faceHeld[3 - p - q];
      }
      else
      {
        const auto [f, g] = OtherCorners(p, q);
        const bool byEdge = !faceHeld[f] && !faceHeld[g] && vertexHeld[p] && vertexHeld[q] &&
          IsEdgeHeld(this->Cells, cell, p, q);
        removal.HeldEdges[EdgeIndex(p, q)] = byEdge;
        held = faceHeld[f] || faceHeld[g] || byEdge;
      }
      if (held)
      {
        ++edges;
        std::replace(labels.begin(), labels.end(), int(labels[p]), int(labels[q]));
      }
    }
  }
  // Euler characteristics: what is held is a part of a sphere, but not all of it.
  const int vertices = static_cast<int>(std::count(vertexHeld.begin(), vertexHeld.end(), true));
  const int pieces = CountLabels(labels);
  const int loops = pieces - (vertices - edges + (D == 3 ? faces : 0));
  // In the plane, and where there is no tunnel that could end, nothing but the cell joins the pieces.
  const bool local = pieces < 2 || D == 2 || this->Numbers[1] == 0 || !this->IsExact;
  const int components = local ? pieces : this->Rest.JoinAround(cell, labels);
  removal.Change[0] = components - 1;
  removal.Change[1] = loops - (pieces - components);
  return removal;
}

template <int D>
void CarvedComplex<D>::Carve(int cell, const Removal<D>& removal)
{
  for (std::size_t i = 0; i < this->Numbers.size(); ++i)
  {
    this->Numbers[i] += removal.Change[i];
  }
  this->Cells.States[cell] = CellState::Carved;
  for (const int vertex : this->Cells.Records[cell].Corners)
  {
    auto& [count, combined] = this->Around[vertex];
    count -= count > 0;
    combined ^= cell;
  }
}

template <int D>
void CarvedComplex<D>::MakeExact()
{
  this->IsExact = true;
  if (this->Numbers[0] == 1)
  {
    return; // no less than that
  }
  const int excess = this->Numbers[0] - this->Rest.CountComponents();
  this->Numbers[0] -= excess;
  this->Numbers[1] -= excess;
}

template <int D>
void CarvedComplex<D>::Keep(int cell, const Removal<D>& removal)
{
  if (removal.Change[0] > 0)
  {
    this->Rest.KeepAsBridge(cell, removal.Components);
  }
}

template <int D>
void CarvedComplex<D>::FindTouched(
  int cell, const Removal<D>& removal, std::vector<int>& touched) const
{
  for (int f = 0; f <= D; ++f)
  {
    const int neighbor = this->Cells.GetNeighbor(cell, f);
    if (this->Cells.IsLeft(neighbor))
    {
      touched.push_back(neighbor);
    }
  }
  if constexpr (D == 3)
  {
    for (int p = 0; p <= D; ++p)
    {
      for (int q = 0; q < p; ++q)
      {
        const int only =
          removal.HeldEdges[EdgeIndex(p, q)] ? FindOnlyHolder(this->Cells, cell, p, q) : -1;
        if (only >= 0)
        {
          touched.push_back(only);
        }
      }
    }
  }
  for (const int vertex : this->Cells.Records[cell].Corners)
  {
    const auto [count, combined] = this->Around[vertex];
    if (count == 1)
    {
      touched.push_back(combined);
    }
  }
}

template class CarvedComplex<2>;
template class CarvedComplex<3>;

} // namespace carving
