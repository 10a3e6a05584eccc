// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Moves vertices of a decimated surface inward, and back before more edges collapse.
 */
#include "Helper/Decimation/Decimator.h"

#include "Core/Protocol/Protocol.h"

#include <utility>

namespace carving::helper
{

void Decimator::Tighten(const std::function<bool()>& goOn)
{
  if (this->Nested || this->Surface.number_of_vertices() > DecimationOptions::ManyVertices)
  {
    return;
  }
  for (const Vertex vertex : this->Surface.vertices())
  {
    if (!goOn())
    {
      return;
    }
    this->MoveInward(vertex);
  }
}

/** Moves a vertex where its cost is less. */
void Decimator::MoveInward(Vertex vertex)
{
  const Point from = this->Surface.point(vertex);
  const Star star(this->Surface, vertex);
  const LocalError error = this->Errors.OfVertex(vertex);
  const Point end = this->Place.SlideInward(star, error, from);
  const double cost = this->Errors.CostOf(star, error, from);
  for (const double share : Shares)
  {
    const Point w = Between(from, end, share);
    if (w == from || this->Errors.CostOf(star, error, w) >= cost)
    {
      return;
    }
    if (this->IsValid(star, w) && this->Bound.Allows(star, w))
    {
      this->Moves.try_emplace(vertex, Move{ from, this->History.GetPoint(vertex) });
      this->Surface.point(vertex) = w;
      this->History.AddMove(this->Surface, vertex, star.Faces);
      this->Collisions.Update(star);
      return;
    }
  }
}

/**
 * Moves the tightened vertices back, or forth again. The queue needs no update: it always belongs to
 * the surface before these moves.
 */
void Decimator::SwapMoves()
{
  for (auto& [vertex, move] : this->Moves)
  {
    std::swap(this->Surface.point(vertex), move.Other);
    this->Collisions.Update(Star(this->Surface, vertex));
  }
}

/** Records that the tightened vertices are back. Then they count as not tightened. */
void Decimator::RecordMovesBack()
{
  for (const auto& [vertex, move] : this->Moves)
  {
    this->History.AddMoveBack(
      this->Surface, vertex, move.ChainPoint, Star(this->Surface, vertex).Faces);
  }
  this->Moves.clear();
}

} // namespace carving::helper
