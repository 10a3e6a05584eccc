// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * How a triangle lies to a tetrahedron, decided exactly.
 */
#ifndef carving_Pierce_h
#define carving_Pierce_h

#include "Core/Mesh/Vector.h"
#include "Helper/Base/Kernels.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/** From one point to another in doubles; its largest entry is 0 just if they are equal. */
struct Difference
{
  carving::Point Along;
  double Most;

  Difference(const Inexact::Point_3& from, const Inexact::Point_3& to)
    : Along{ to.x() - from.x(), to.y() - from.y(), to.z() - from.z() }
    , Most(
        std::max({ std::abs(this->Along[0]), std::abs(this->Along[1]), std::abs(this->Along[2]) }))
  {
  }
};

/** Two differences, which may be asked for their determinant with others. */
class SpannedPlane
{
public:
  SpannedPlane(const Difference& u, const Difference& v)
    : Normal(carving::Cross(u.Along, v.Along))
    , Limit(Bound * u.Most * v.Most)
    , Usable(std::min(u.Most, v.Most) > Tiny && std::max(u.Most, v.Most) < Huge)
  {
  }

  /**
   * Whether rounding cannot turn the determinant's sign: its error is below Bound times the product of
   * the differences' largest entries, by some three times.
   */
  bool FindSide(const Difference& w, CGAL::Orientation& side) const
  {
    const double determinant = carving::Dot(this->Normal, w.Along);
    side = determinant > 0.0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
    return this->Usable && w.Most > Tiny && w.Most < Huge &&
      std::abs(determinant) > this->Limit * w.Most;
  }

private:
  static constexpr double Bound = 1.5e-14, Tiny = 1e-90, Huge = 1e90; // neither under- nor overflow
  carving::Point Normal;
  double Limit;
  bool Usable;
};

/** A triangle that has an area, prepared for being compared with many tetrahedra. */
class Piercer
{
public:
  explicit Piercer(const Corners3& corners);

  /**
   * With a positively oriented tetrahedron. The triangle does not meet its interior just if some plane has
   * the one on its one and the other on its other side, touching allowed; candidates are the planes of the
   * faces, that of the triangle, and those along an edge of each.
   */
  Contact FindContact(const Corners4& tetrahedron) const;

  /** The side of its plane that a point is on. */
  CGAL::Orientation SideOf(const Inexact::Point_3& x) const;

private:
  bool IsClose(const Corners4& tetrahedron) const;

  Corners3 Corners;
  SpannedPlane Plane;
  carving::Point Least, Most; ///< of its bounding box
};

/** Whether two triangles lie in one plane and their interiors meet. */
bool OverlapInPlane(const Corners3& a, const Corners3& b);

/** Whether two triangles in one plane face the same way. */
bool FaceAlike(const Corners3& a, const Corners3& b);

#endif
