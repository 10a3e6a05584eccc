// SPDX-License-Identifier: BSD-3-Clause
#include "CarvedComplex.h"

#include <algorithm>

namespace carving
{
namespace
{

/** A number for the edge between two corners of a tetrahedron, the second of which is the smaller. */
int EdgeIndex(int p, int q)
{
  return p * (p - 1) / 2 + q;
}

} // namespace

template <int D>
CarvedComplex<D>::CarvedComplex(const Decomposition<D>& mesh, const std::vector<CellState>& states)
  : Records(mesh.Cells.size())
  , States(states)
  , Rest(mesh, this->States)
  , Around(mesh.Surface.Points.size(), { 0, 0 })
{
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    Record& record = this->Records[cell];
    record.Corners = mesh.Cells[cell];
    for (int f = 0; f <= D; ++f)
    {
      record.Behind[f] = mesh.Constraints[cell][f] >= 0 ? Facet
        : mesh.Neighbors[cell][f] >= 0                  ? mesh.Neighbors[cell][f]
                                                        : Exterior;
    }
    for (const int vertex : record.Corners)
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
  const int behind = this->Records[cell].Behind[f];
  return behind == Facet || (behind >= 0 && this->IsLeft(behind));
}

/** A turn around the edge between two corners of a tetrahedron, one way or the other. */
template <int D>
class CarvedComplex<D>::Turn
{
public:
  static constexpr int Nothing = -3;

  Turn(const CarvedComplex& complex, int cell, int p, int q, int way)
    : Complex(complex)
    , Edge{ complex.Records[cell].Corners[p], complex.Records[cell].Corners[q] }
    , Start(cell)
    , At(cell)
  {
    const std::array<int, 2> others = OtherCorners(p, q);
    this->Through = others[way];
    this->Ahead = complex.Records[cell].Corners[others[1 - way]];
  }

  /** The first that holds the edge, Exterior where there is none before that, or Nothing so far. */
  int GetHolder() const
  {
    return this->Holder;
  }

  /** Where it has come to. */
  int GetCell() const
  {
    return this->At;
  }

  /** Whether something else than the tetrahedron holds the edge, as far as is known. */
  bool IsHeld() const
  {
    return this->Holder == Facet || (this->Holder >= 0 && this->Holder != this->Start);
  }

  /** Goes to the next cell around the edge. */
  void Advance()
  {
    this->At = this->Complex.Records[this->At].Behind[this->Through];
    if (this->At < 0 || this->At == this->Start || this->Complex.IsLeft(this->At))
    {
      this->Holder = this->At;
      return;
    }
    const auto& corners = this->Complex.Records[this->At].Corners;
    const int behind = this->Ahead;
    for (int corner = 0; corner <= D; ++corner)
    {
      const int vertex = corners[corner];
      if (vertex == behind)
      {
        this->Through = corner;
      }
      else if (vertex != this->Edge[0] && vertex != this->Edge[1])
      {
        this->Ahead = vertex;
      }
    }
  }

private:
  const CarvedComplex& Complex;
  std::array<int, 2> Edge;
  int Start;
  int At;
  int Through; ///< the next step goes through the face opposite to this corner
  int Ahead;   ///< of that face, the vertex off the edge
  int Holder = Nothing;
};

/**
 * Whether something else than the tetrahedron, and than its faces, holds the edge between two corners.
 * Turns both ways at once, so that it costs as much as the shorter one.
 */
template <int D>
bool CarvedComplex<D>::IsEdgeHeld(int cell, int p, int q) const
{
  Turn one(*this, cell, p, q, 0), other(*this, cell, p, q, 1);
  for (;;)
  {
    for (Turn* turn : { &one, &other })
    {
      if (turn->GetHolder() == Turn::Nothing)
      {
        turn->Advance();
        if (turn->IsHeld())
        {
          return true;
        }
        if (one.GetCell() == other.GetCell()) // all around, or both are outside C0
        {
          return false;
        }
      }
    }
  }
}

/** The only cell besides the one carved last that holds the edge between two corners of that; else -1. */
template <int D>
int CarvedComplex<D>::FindOnlyHolder(int cell, int p, int q) const
{
  int only = -1;
  for (const int way : { 0, 1 })
  {
    Turn turn(*this, cell, p, q, way);
    while (turn.GetHolder() == Turn::Nothing)
    {
      turn.Advance();
    }
    const int holder = turn.GetHolder();
    if (holder == Facet || holder == cell || (only >= 0 && holder >= 0 && holder != only))
    {
      return -1;
    }
    only = std::max(only, holder);
  }
  return only;
}

template <int D>
Removal<D> CarvedComplex<D>::Examine(int cell)
{
  Removal<D> removal;
  std::array<bool, D + 1> faceHeld;
  int faces = 0;
  for (int f = 0; f <= D; ++f)
  {
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
      if (this->IsEdgeHeld(cell, p, q))
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
    const int count = this->Around[this->Records[cell].Corners[corner]][0];
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
          this->IsEdgeHeld(cell, p, q);
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
  const bool local = pieces < 2 || D == 2 || this->Numbers[1] == 0;
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
  this->States[cell] = CellState::Carved;
  for (const int vertex : this->Records[cell].Corners)
  {
    auto& [count, combined] = this->Around[vertex];
    count -= count > 0;
    combined ^= cell;
  }
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
  for (const int behind : this->Records[cell].Behind)
  {
    if (behind >= 0 && this->IsLeft(behind))
    {
      touched.push_back(behind);
    }
  }
  if constexpr (D == 3)
  {
    for (int p = 0; p <= D; ++p)
    {
      for (int q = 0; q < p; ++q)
      {
        const int only = removal.HeldEdges[EdgeIndex(p, q)] ? this->FindOnlyHolder(cell, p, q) : -1;
        if (only >= 0)
        {
          touched.push_back(only);
        }
      }
    }
  }
  for (const int vertex : this->Records[cell].Corners)
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
