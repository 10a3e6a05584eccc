// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Budget/CarvedComplex.h"

#include "Core/Budget/EdgeRotation.h"

#include <algorithm>

namespace carving
{
namespace
{

/**
 * Rotates from a carved cell around an edge to the first face that M or a remaining cell shares,
 * and returns the far side of the face. Without such a face: Outside or the cell itself.
 */
RemainingCells<3>::Behind FindNextShared(
  const RemainingCells<3>& cells, int cell, EdgeRotation rotation)
{
  auto next = rotation.GetNext();
  while (!cells.IsShared(next) && next.Cell != Outside && next.Cell != cell)
  {
    rotation.Enter(next.Cell);
    next = rotation.GetNext();
  }
  return next;
}

/**
 * The remaining cell that is found in both directions around the edge between corners p and q of a
 * carved cell, or in one if the other leads to Outside. -1 if there is none, or if either direction
 * leads to a facet of M.
 */
int FindLastCell(const RemainingCells<3>& cells, int cell, int p, int q)
{
  const auto one = FindNextShared(cells, cell, { cells, cell, p, q, 0 });
  const auto other = FindNextShared(cells, cell, { cells, cell, p, q, 1 });
  const bool isOnly = one.Cell == other.Cell || one.Cell == Outside || other.Cell == Outside;
  const int last = std::max<int>(one.Cell, other.Cell);
  return isOnly && !one.IsFacet && !other.IsFacet && last != cell ? last : -1;
}

template <std::size_t N>
int Count(const std::array<bool, N>& flags)
{
  return static_cast<int>(std::count(flags.begin(), flags.end(), true));
}

} // namespace

template <int D>
CarvedComplex<D>::CarvedComplex(const Decomposition<D>& mesh, const std::vector<CellState>& states)
  : Cells(mesh, states)
  , Graph(mesh, this->Cells.States)
  , Stars(mesh.Surface.Points.size(), { 0, 0 })
{
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (const int vertex : mesh.Cells[cell])
    {
      auto& [count, combined] = this->Stars[vertex];
      count = states[cell] == CellState::Permanent || count < 0 ? -1 : count + 1;
      combined ^= cell;
    }
  }
  for (const auto& facet : mesh.Surface.Facets)
  {
    for (const int vertex : facet)
    {
      this->Stars[vertex].Count = -1;
    }
  }
}

template <int D>
RemovalEffect<D> CarvedComplex<D>::Examine(int cell)
{
  RemovalEffect<D> effect;
  const Faces sharedFaces = this->FindSharedFaces(cell);
  const int faces = Count(sharedFaces);
  if (faces >= D) // A is a sphere, or a disk, with which nothing changes
  {
    effect.Change[D - 1] = faces - D;
  }
  else if (D == 3 && faces == 2)
  {
    this->ExamineEdge(cell, sharedFaces, effect);
  }
  else
  {
    this->ExaminePieces(cell, sharedFaces, effect);
  }
  return effect;
}

/** Per corner of a cell: whether the face opposite to the corner belongs to A. */
template <int D>
typename CarvedComplex<D>::Faces CarvedComplex<D>::FindSharedFaces(int cell) const
{
  Faces shared;
  for (int f = 0; f <= D; ++f)
  {
    const auto& behind = this->Cells.Records[cell].Faces[f];
    this->Fetch(std::max<int>(behind.Cell, 0)); // most rotations begin there
    shared[f] = this->Cells.IsShared(behind);
  }
  return shared;
}

/**
 * Whether the edge between two corners belongs to A. Both corners have to. Notes shared edges in
 * `effect`.
 */
template <int D>
bool CarvedComplex<D>::IsEdgeShared(
  int cell, int p, int q, const Faces& sharedFaces, RemovalEffect<D>& effect) const
{
  if constexpr (D == 2)
  {
    return sharedFaces[3 - p - q];
  }
  else
  {
    const auto [f, g] = OtherCorners(p, q);
    if (sharedFaces[f] || sharedFaces[g])
    {
      return true;
    }
    bool& shared = effect.SharedEdges[p][q];
    shared = AnyAroundEdge(
      this->Cells, cell, p, q, [this](const auto& next) { return this->Cells.IsShared(next); });
    return shared;
  }
}

/**
 * Examines a tetrahedron with two faces in A, which form a disk. The edge between the other two
 * faces joins two points of the disk's boundary, and so closes a loop if the edge belongs to A.
 */
template <int D>
void CarvedComplex<D>::ExamineEdge(
  int cell, const Faces& sharedFaces, RemovalEffect<D>& effect) const
{
  const auto begin = sharedFaces.begin(), end = sharedFaces.end();
  const auto f = std::find(begin, end, false), g = std::find(f + 1, end, false);
  const auto [q, p] = OtherCorners(static_cast<int>(f - begin), static_cast<int>(g - begin));
  effect.Change[1] = this->IsEdgeShared(cell, p, q, sharedFaces, effect);
}

/** Examines a cell with at most one face in A. */
template <int D>
void CarvedComplex<D>::ExaminePieces(int cell, const Faces& sharedFaces, RemovalEffect<D>& effect)
{
  auto& labels = effect.Components;
  int vertices = 0;
  for (int corner = 0; corner <= D; ++corner)
  {
    const int count = this->Stars[this->Cells.Records[cell].Corners[corner]].Count;
    const bool shared = count < 0 || count > 1;
    labels[corner] = shared ? corner : -1;
    vertices += shared;
  }
  int edges = 0;
  for (int p = 0; p <= D; ++p)
  {
    for (int q = 0; q < p; ++q)
    {
      if (labels[p] >= 0 && labels[q] >= 0 && this->IsEdgeShared(cell, p, q, sharedFaces, effect))
      {
        ++edges;
        MergeLabels(labels, labels[p], labels[q]);
      }
    }
  }
  // A is a proper part of a sphere, so its Euler characteristic is `pieces` minus `loops`.
  const int faces = D == 3 ? Count(sharedFaces) : 0;
  const int pieces = CountLabels(labels);
  const int loops = pieces - (vertices - edges + faces);
  // In the plane, and while there is no tunnel, only the cell joins the pieces.
  if (pieces > 1 && D == 3 && this->Numbers[1] > 0 && this->Exact)
  {
    this->Search.Join(this->Graph, cell, labels);
  }
  const int components = CountLabels(labels);
  effect.Change[0] = components - 1;
  effect.Change[1] = loops - (pieces - components);
}

template <int D>
void CarvedComplex<D>::MakeExact()
{
  this->Exact = true;
  if (this->Numbers[0] > 1)
  {
    const int excess = this->Numbers[0] - this->Graph.CountComponents();
    this->Numbers[0] -= excess;
    this->Numbers[1] -= excess;
  }
}

template <int D>
void CarvedComplex<D>::Carve(int cell, const RemovalEffect<D>& effect)
{
  for (std::size_t i = 0; i < this->Numbers.size(); ++i)
  {
    this->Numbers[i] += effect.Change[i];
  }
  this->Cells.States[cell] = CellState::Carved;
  for (const int vertex : this->Cells.Records[cell].Corners)
  {
    auto& [count, combined] = this->Stars[vertex];
    count -= count > 0;
    combined ^= cell;
  }
}

template <int D>
void CarvedComplex<D>::Keep(int cell, const RemovalEffect<D>& effect)
{
  if (effect.Change[0] > 0)
  {
    this->Graph.KeepAsBridge(cell, effect.Components);
  }
}

template <int D>
void CarvedComplex<D>::FindAffected(
  int cell, const RemovalEffect<D>& effect, std::vector<int>& affected) const
{
  for (int f = 0; f <= D; ++f)
  {
    const int neighbor = this->Cells.GetNeighbor(cell, f);
    if (this->Cells.IsRemaining(neighbor))
    {
      affected.push_back(neighbor);
    }
  }
  if constexpr (D == 3)
  {
    for (int p = 0; p <= D; ++p)
    {
      for (int q = 0; q < p; ++q)
      {
        const int last = effect.SharedEdges[p][q] ? FindLastCell(this->Cells, cell, p, q) : -1;
        if (last >= 0)
        {
          affected.push_back(last);
        }
      }
    }
  }
  for (const int vertex : this->Cells.Records[cell].Corners)
  {
    const auto [count, combined] = this->Stars[vertex];
    if (count == 1)
    {
      affected.push_back(combined);
    }
  }
}

template class CarvedComplex<2>;
template class CarvedComplex<3>;

} // namespace carving
