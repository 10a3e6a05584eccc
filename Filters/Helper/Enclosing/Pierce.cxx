// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/Pierce.h"

#include <tuple>

namespace carving::helper
{
namespace
{

/**
 * The side of a plane through three points. Equal points are frequent and need no exact arithmetic.
 */
CGAL::Orientation SideOfPlane(const Inexact::Point_3& a, const Inexact::Point_3& b,
  const Inexact::Point_3& c, const Inexact::Point_3& x)
{
  return x == a || x == b || x == c ? CGAL::COPLANAR : CGAL::orientation(a, b, c, x);
}

/** Whether the plane of a face of the tetrahedron separates the triangle from it. */
bool FaceSeparates(const Corners3& t, const Corners4& k)
{
  for (const auto& f : FaceCorners)
  {
    const SpannedPlane plane({ k[f[0]], k[f[1]] }, { k[f[0]], k[f[2]] });
    bool outside = true;
    for (int i = 0; i < 3 && outside; ++i)
    {
      CGAL::Orientation side;
      if (!plane.FindSide({ k[f[0]], t[i] }, side))
      {
        side = SideOfPlane(k[f[0]], k[f[1]], k[f[2]], t[i]);
      }
      // A point in front of a face sees it counter-clockwise.
      outside = side != CGAL::NEGATIVE;
    }
    if (outside)
    {
      return true;
    }
  }
  return false;
}

} // namespace

bool CrossesInside(const Inexact::Point_3& p, const Inexact::Point_3& q, const Corners3& t)
{
  const CGAL::Orientation turn = CGAL::orientation(p, q, t[0], t[1]);
  return turn != CGAL::COPLANAR && CGAL::orientation(p, q, t[1], t[2]) == turn &&
    CGAL::orientation(p, q, t[2], t[0]) == turn;
}

Piercer::Piercer(const Corners3& corners)
  : Corners(corners)
  , Plane({ corners[0], corners[1] }, { corners[0], corners[2] })
{
  for (int i = 0; i < 3; ++i)
  {
    std::tie(this->Least[i], this->Most[i]) =
      std::minmax({ corners[0][i], corners[1][i], corners[2][i] });
  }
}

CGAL::Orientation Piercer::SideOf(const Inexact::Point_3& x) const
{
  CGAL::Orientation side;
  return this->Plane.FindSide({ this->Corners[0], x }, side)
    ? side
    : SideOfPlane(this->Corners[0], this->Corners[1], this->Corners[2], x);
}

bool Piercer::IsBeside(const Corners3& other) const
{
  CGAL::Orientation side = CGAL::COPLANAR;
  for (const auto& x : other)
  {
    if (std::find(this->Corners.begin(), this->Corners.end(), x) == this->Corners.end())
    {
      const CGAL::Orientation next = this->SideOf(x);
      if (next == CGAL::COPLANAR || next == -side)
      {
        return false;
      }
      side = next;
    }
  }
  return side != CGAL::COPLANAR;
}

/**
 * Whether the triangle's bounding box meets that of the tetrahedron in more than their boundaries.
 */
bool Piercer::MeetsBox(const Corners4& k) const
{
  for (int i = 0; i < 3; ++i)
  {
    const auto [lower, upper] = std::minmax({ k[0][i], k[1][i], k[2][i], k[3][i] });
    const bool apart = this->Least[i] == this->Most[i]
      ? this->Least[i] > upper || this->Most[i] < lower
      : this->Least[i] >= upper || this->Most[i] <= lower;
    if (apart)
    {
      return false;
    }
  }
  return true;
}

bool Piercer::MeetsInterior(const Corners4& k, const std::array<CGAL::Orientation, 4>& sides) const
{
  const Corners3& t = this->Corners;
  std::array<bool, 3> separates = { true, true, true };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      if (sides[i] * sides[j] >= 0)
      {
        continue;
      }
      const auto& [below, above] = sides[i] < 0 ? std::tie(k[i], k[j]) : std::tie(k[j], k[i]);
      bool isInside = true;
      for (int e = 0; e < 3; ++e)
      {
        const bool isLeft = CGAL::orientation(below, above, t[e], t[(e + 1) % 3]) == CGAL::POSITIVE;
        separates[e] &= !isLeft;
        isInside &= isLeft;
      }
      if (isInside)
      {
        return true;
      }
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    for (int e = 0; e < 3 && sides[i] == CGAL::COPLANAR; ++e)
    {
      const auto &a = t[e], &b = t[(e + 1) % 3], &c = t[(e + 2) % 3];
      separates[e] = separates[e] &&
        (k[i] == a || k[i] == b || CGAL::coplanar_orientation(a, b, c, k[i]) != CGAL::POSITIVE);
    }
  }
  return std::count(separates.begin(), separates.end(), true) == 0 && !FaceSeparates(t, k);
}

Contact Piercer::FindContact(const Corners4& k) const
{
  Contact contact;
  if (!this->MeetsBox(k))
  {
    return contact;
  }
  int above = 0, below = 0;
  int last = 0; // the last corner off the plane: the face opposite to it may be in the plane
  std::array<CGAL::Orientation, 4> sides;
  for (int i = 0; i < 4; ++i)
  {
    sides[i] = this->SideOf(k[i]);
    above += sides[i] == CGAL::POSITIVE;
    below += sides[i] == CGAL::NEGATIVE;
    last = sides[i] == CGAL::COPLANAR ? last : i;
  }
  if (above > 0 && below > 0)
  {
    contact.Pierces = this->MeetsInterior(k, sides);
  }
  else if (above + below == 1)
  {
    const auto& [a, b, c] = FaceCorners[last];
    contact.Face = Overlap(this->Corners, { k[a], k[b], k[c] }) ? last : -1;
  }
  return contact;
}

} // namespace carving::helper
