// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Whether and how a triangle meets a tetrahedron, decided exactly.
 */
#ifndef carving_Pierce_h
#define carving_Pierce_h

#include "Core/Mesh/Box.h"
#include "Helper/Base/CoplanarTriangles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carving::helper
{

using Corners4 = std::array<Inexact::Point_3, 4>;

/** How a triangle meets a tetrahedron. */
struct Contact
{
  bool Pierces = false; ///< the triangle meets the interior
  int Face = -1;        ///< if not, the face that the triangle overlaps in an area; -1: none

  bool Exists() const
  {
    return this->Pierces || this->Face >= 0;
  }
};

/**
 * The vector from one point to another in doubles. `Most` is 0 if and only if the points are equal.
 */
struct Difference
{
  Point Along;
  double Most; ///< the largest absolute coordinate

  Difference(const Inexact::Point_3& from, const Inexact::Point_3& to)
    : Along{ to.x() - from.x(), to.y() - from.y(), to.z() - from.z() }
    , Most(
        std::max({ std::abs(this->Along[0]), std::abs(this->Along[1]), std::abs(this->Along[2]) }))
  {
  }
};

/** The plane that two differences span: a floating-point filter for orientations. */
class SpannedPlane
{
public:
  SpannedPlane(const Difference& u, const Difference& v)
    : Normal(Cross(u.Along, v.Along))
    , Limit(Bound * u.Most * v.Most)
    , Usable(std::min(u.Most, v.Most) > Tiny && std::max(u.Most, v.Most) < Huge)
  {
  }

  /**
   * Sets `side` to the sign of the determinant of u, v and w, and returns whether the sign is
   * certain: the rounding error is less than a third of Bound times the product of the three
   * largest coordinates.
   */
  bool FindSide(const Difference& w, CGAL::Orientation& side) const
  {
    const double determinant = Dot(this->Normal, w.Along);
    side = determinant > 0.0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
    return this->IsCertain(std::abs(determinant), w.Most);
  }

  /** Whether the determinant is certainly positive for every w in a box. */
  bool IsPositiveIn(const Box& box) const
  {
    double most = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      most = std::max({ most, std::abs(box.Lower[k]), std::abs(box.Upper[k]) });
    }
    return this->IsCertain(LeastProduct(this->Normal, box), most);
  }

private:
  /** Whether a positive determinant exceeds its rounding error. `most` is that of w. */
  bool IsCertain(double determinant, double most) const
  {
    return this->Usable && most > Tiny && most < Huge && determinant > this->Limit * most;
  }

  static constexpr double Bound = 1.5e-14;
  static constexpr double Tiny = 1e-90, Huge = 1e90; ///< in between, nothing under- or overflows
  Point Normal;
  double Limit;
  bool Usable;
};

/**
 * Whether the segment between points on either side of a triangle's plane crosses the inside of the
 * triangle.
 */
bool CrossesInside(const Inexact::Point_3& p, const Inexact::Point_3& q, const Corners3& triangle);

/** A triangle that has an area, prepared for comparison with many tetrahedra. */
class Piercer
{
public:
  explicit Piercer(const Corners3& corners);

  const Corners3& GetCorners() const
  {
    return this->Corners;
  }

  /** The contact with a positively oriented tetrahedron. */
  Contact FindContact(const Corners4& tetrahedron) const;

  /** The side of the triangle's plane on which a point lies. */
  CGAL::Orientation SideOf(const Inexact::Point_3& x) const;

  /**
   * Whether another triangle lies on one side of this one's plane, common corners apart. Then the
   * triangles have nothing else in common.
   */
  bool IsBeside(const Corners3& other) const;

private:
  bool MeetsBox(const Corners4& tetrahedron) const;
  /**
   * Whether the triangle meets the interior of a tetrahedron that its plane cuts. The cut is a
   * convex polygon, as the triangle is. Two of them have no interior point in common if and only if
   * the line of an edge of one separates them, where touching the line is allowed. An edge of the
   * cut is on the plane of a face; a corner is on an edge that crosses the plane, or on the plane.
   */
  bool MeetsInterior(
    const Corners4& tetrahedron, const std::array<CGAL::Orientation, 4>& sides) const;

  Corners3 Corners;
  SpannedPlane Plane;
  Point Least, Most; ///< of the bounding box
};

} // namespace carving::helper

#endif
