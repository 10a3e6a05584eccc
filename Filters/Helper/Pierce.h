// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * How a triangle lies to a tetrahedron, decided exactly.
 */
#ifndef carving_Pierce_h
#define carving_Pierce_h

#include "Kernels.h"

#include <array>

using Corners3 = std::array<Inexact::Point_3, 3>;
using Corners4 = std::array<Inexact::Point_3, 4>;

/** How a triangle lies to a tetrahedron. */
struct Contact
{
  bool Pierces = false; ///< it meets the interior
  int Face = -1;        ///< else the face that it overlaps in an area; -1: none

  bool Exists() const
  {
    return this->Pierces || this->Face >= 0;
  }
};

/**
 * Of a triangle that has an area with a positively oriented tetrahedron. It does not meet the interior just
 * if some plane has the one on its one and the other on its other side, touching allowed; candidates are
 * the planes of the faces, that of the triangle, and those along an edge of each.
 */
Contact FindContact(const Corners3& triangle, const Corners4& tetrahedron);

/** Whether two triangles lie in one plane and their interiors meet. */
bool OverlapInPlane(const Corners3& a, const Corners3& b);

/** Whether two triangles in one plane face the same way. */
bool FaceAlike(const Corners3& a, const Corners3& b);

#endif
