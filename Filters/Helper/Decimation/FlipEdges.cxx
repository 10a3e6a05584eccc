// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Flips edges of a decimated surface where that takes the surface inward.
 */
#include "Helper/Decimation/Decimator.h"

#include "Core/Mesh/Vector.h"
#include "Helper/Base/Kernels.h"

#include <CGAL/boost/graph/Euler_operations.h>

namespace carving::helper
{
namespace
{

/**
 * The least volume that a flip takes from the solid, in lengths of the edge times areas of the two
 * faces. A flip that takes less hardly brings the surface closer, and leaves thin faces.
 */
constexpr double LeastDepth = 0.001;

} // namespace

/** Flips the edges at a vertex that may be flipped, where M stays enclosed. */
void Decimator::FlipAround(Vertex vertex)
{
  std::vector<HalfEdge> spokes;
  for (const HalfEdge spoke :
    CGAL::halfedges_around_target(this->Surface.halfedge(vertex), this->Surface))
  {
    spokes.push_back(spoke);
  }
  for (const HalfEdge spoke : spokes)
  {
    if (!this->MayFlip(spoke))
    {
      continue;
    }
    const Star star = Star::OfFlip(this->Surface, spoke);
    const Point& w = this->Surface.point(this->Surface.target(this->Surface.next(spoke)));
    if (this->IsValid(star, w) && this->Bound.Allows(star, w))
    {
      this->Flip(spoke, star);
    }
  }
}

/** Whether the surface is convex at an edge, and would have no edge twice without this one. */
bool Decimator::MayFlip(HalfEdge edge) const
{
  const HalfEdge back = this->Surface.opposite(edge);
  const Vertex ends[] = { this->Surface.source(edge), this->Surface.target(edge) };
  const Vertex others[] = { this->Surface.target(this->Surface.next(edge)),
    this->Surface.target(this->Surface.next(back)) };
  if (others[0] == others[1] || this->Surface.halfedge(others[0], others[1]).is_valid() ||
    this->Surface.degree(ends[0]) <= 3 || this->Surface.degree(ends[1]) <= 3)
  {
    return false;
  }
  const Point &a = this->Surface.point(ends[0]), &b = this->Surface.point(ends[1]);
  const Point &c = this->Surface.point(others[0]), &d = this->Surface.point(others[1]);
  const Point normal = Cross(b - a, c - a);
  const double area = (Length(normal) + Length(Cross(a - b, d - b))) / 2.0;
  const double volume = -Dot(normal, d - a) / 6.0;
  return volume > LeastDepth * Length(b - a) * area &&
    CGAL::orientation(ToInexact(a), ToInexact(b), ToInexact(c), ToInexact(d)) == CGAL::NEGATIVE;
}

void Decimator::Flip(HalfEdge edge, const Star& star)
{
  CGAL::Euler::flip_edge(edge, this->Surface);
  this->History.AddFlip(this->Surface, star.Faces);
  this->Collisions.Update(star);
  for (const HalfEdge side : { edge, this->Surface.opposite(edge) })
  {
    for (const HalfEdge corner : { side, this->Surface.next(side) })
    {
      for (const HalfEdge spoke : CGAL::halfedges_around_target(corner, this->Surface))
      {
        this->Refresh(spoke);
      }
    }
  }
  this->PushBound(edge); // its ends are others now
}

} // namespace carving::helper
