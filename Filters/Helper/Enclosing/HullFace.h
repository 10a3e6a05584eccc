// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * What may be outside of a PiercedMesh by a rounding.
 */
#ifndef carving_HullFace_h
#define carving_HullFace_h

#include "Helper/Enclosing/PiercedMesh.h"

namespace carving::helper
{

/** The box around points. */
template <std::size_t N>
CGAL::Bbox_3 BoundsOf(const std::array<Inexact::Point_3, N>& corners)
{
  CGAL::Bbox_3 bounds;
  for (const Inexact::Point_3& p : corners)
  {
    bounds += p.bbox();
  }
  return bounds;
}

/** A hull face. Roundings of vertices dent the hull, which leaves pieces of parts outside. */
struct HullFace
{
  /** Face f of a cell. */
  HullFace(const PiercedMesh::Delaunay& mesh, const PiercedMesh::Cell& cell, int f);

  /** The bounds of what is near the face. */
  CGAL::Bbox_3 GetBounds() const;

  /** A flat pyramid on the face with its apex outside. */
  Corners4 GetPyramid() const;

  Corners3 Corners;
  Point Origin, Center;
  bool IsNeedle; ///< whether rounding decides where the plane of the face looks
  Point Normal;  ///< outward, of length 1; that of the faces around if this is a needle
  double Height; ///< of what may be outside
};

} // namespace carving::helper

#endif
