// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Moves vertices of a decimated surface inward, and back before more edges collapse.
 */
#include "Helper/Decimation/Decimator.h"

#include "Core/Mesh/Vector.h"

#include <utility>

namespace carving::helper
{
namespace
{

/**
 * A vertex that is tightened aims below the position of least error, by this multiple of the
 * largest distance of its faces. From there, the direction in which the volume falls fastest
 * outweighs the error: the surface ends closer to M on average.
 */
constexpr double Depths = 10.0;

/** The error with its least value moved inward, by `depth` in a plane. */
LocalError Lowered(LocalError error, const Star& star, double depth)
{
  const Point normal = star.SumNormals();
  const double length = Length(normal);
  if (length > 0.0)
  {
    error.Error.B = error.Error.B + depth * error.Error.Trace() / length * normal;
  }
  return error;
}

} // namespace

void Decimator::Tighten(const std::function<bool()>& goOn)
{
  if (!this->FitsClosely())
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

/**
 * Moves a vertex inward to where the solid has less volume, but no face is farther from the surface
 * as given.
 */
void Decimator::MoveInward(Vertex vertex)
{
  const Point from = this->Surface.point(vertex);
  const Star star(this->Surface, vertex);
  const double farthest = this->Errors.FindFarthest(star, from, 0.0);
  const LocalError error = Lowered(this->Errors.OfVertex(vertex), star, Depths * farthest);
  const Point end = this->Place.SlideInward(star, error, from);
  for (const double share : Shares)
  {
    const Point w = Between(from, end, share);
    if (w == from || error.At(w) >= error.At(from))
    {
      return;
    }
    if (this->Errors.FindFarthest(star, w, farthest) <= farthest && this->IsValid(star, w) &&
      this->Bound.Allows(star, w))
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
 * Moves the tightened vertices back, or forth again. The queue needs no update: it always belongs
 * to the surface before these moves.
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
