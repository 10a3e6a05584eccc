// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/Pierce.h"

#include <CGAL/Filtered_predicate.h>

#include <algorithm>
#include <tuple>

using namespace carving;

namespace
{

/** On which side of the plane through p and q that is parallel to ab the point x lies. */
template <class Kernel>
struct SideAlongEdges
{
  using result_type = CGAL::Orientation;
  using Point = typename Kernel::Point_3;

  result_type operator()(
    const Point& p, const Point& q, const Point& a, const Point& b, const Point& x) const
  {
    return CGAL::orientation(q - p, b - a, x - p);
  }
};
using FilteredSideAlongEdges = CGAL::Filtered_predicate<SideAlongEdges<Inexact::Exact_kernel>,
  SideAlongEdges<Inexact::Approximate_kernel>, Inexact::C2E, Inexact::C2F>;

constexpr int Edges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
constexpr int Others[6][2] = { { 2, 3 }, { 1, 3 }, { 1, 2 }, { 0, 3 }, { 0, 2 }, { 0, 1 } };

/** Common corners are frequent: what they are on is known without exact arithmetic. */
CGAL::Orientation SideOfPlane(const Inexact::Point_3& a, const Inexact::Point_3& b,
  const Inexact::Point_3& c, const Inexact::Point_3& x)
{
  return x == a || x == b || x == c ? CGAL::COPLANAR : CGAL::orientation(a, b, c, x);
}

/** Whether a face of the tetrahedron has all of the triangle in front of it or in its plane. */
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
      // Corners that see a face counter-clockwise are in front of it.
      outside = side != CGAL::NEGATIVE;
    }
    if (outside)
    {
      return true;
    }
  }
  return false;
}

/** For each corner of the triangle the same one of the tetrahedron; -1: none. */
std::array<int, 3> CommonCorners(const Corners3& t, const Corners4& k)
{
  std::array<int, 3> common;
  for (int i = 0; i < 3; ++i)
  {
    const auto found = std::find(k.begin(), k.end(), t[i]);
    common[i] = found == k.end() ? -1 : static_cast<int>(found - k.begin());
  }
  return common;
}

bool EdgesSeparate(const Corners3& t, const Corners4& k)
{
  const std::array<int, 3> common = CommonCorners(t, k);
  const std::array<Difference, 3> ofTriangle = { Difference(t[0], t[1]), Difference(t[1], t[2]),
    Difference(t[2], t[0]) };
  for (int e = 0; e < 6; ++e)
  {
    const auto& [first, second] = Edges[e];
    const auto& p = k[first];
    const auto& q = k[second];
    const Difference edge(p, q);
    const std::array<Difference, 2> toOthers = { Difference(p, k[Others[e][0]]),
      Difference(p, k[Others[e][1]]) };
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3, last = (i + 2) % 3;
      const auto& a = t[i];
      const auto& b = t[next];
      const SpannedPlane planes(edge, ofTriangle[i]);
      const auto sideOf = [&](const Inexact::Point_3& x, const Difference& toX)
      {
        CGAL::Orientation side;
        return planes.FindSide(toX, side) ? side : FilteredSideAlongEdges()(p, q, a, b, x);
      };
      const auto sideOfOther = [&](int n)
      {
        const int beyond = Others[e][1 - n];
        const bool bothInPlane = common[i] >= 0 && common[next] >= 0 && common[i] != beyond &&
          common[next] != beyond; // the edge is one of p, q and this corner
        return bothInPlane ? CGAL::ZERO : sideOf(k[Others[e][n]], toOthers[n]);
      };
      const int r = sideOfOther(0), s = sideOfOther(1);
      if (r * s < 0 || (r == 0 && s == 0))
      {
        continue; // no plane that supports the tetrahedron, or parallel edges
      }
      const int own = r != 0 ? r : s;
      const auto isBeyond = [&](int corner)
      {
        return common[corner] == first || common[corner] == second ||
          own * sideOf(t[corner], { p, t[corner] }) <= 0;
      };
      // The side of a is that of b: the plane is parallel to their edge.
      const bool touches = common[next] == first || common[next] == second;
      if ((touches || isBeyond(i)) && isBeyond(last))
      {
        return true;
      }
    }
  }
  return false;
}

/** Two coordinates in which a triangle keeps an area, in the order in which it is counter-clockwise. */
std::array<int, 2> ProjectionOf(const Corners3& t)
{
  for (const auto& [x, y] : { std::array{ 0, 1 }, std::array{ 1, 2 }, std::array{ 2, 0 } })
  {
    const auto flat = [x = x, y = y](const Inexact::Point_3& p)
    { return Inexact::Point_2(p[x], p[y]); };
    const CGAL::Orientation turn = CGAL::orientation(flat(t[0]), flat(t[1]), flat(t[2]));
    if (turn != CGAL::COLLINEAR)
    {
      return turn == CGAL::POSITIVE ? std::array{ x, y } : std::array{ y, x };
    }
  }
  return { 0, 1 }; // not for a triangle that has an area
}

using Flat = std::array<Inexact::Point_2, 3>;

Flat Project(const Corners3& t, const std::array<int, 2>& axes)
{
  Flat flat;
  for (int i = 0; i < 3; ++i)
  {
    flat[i] = { t[i][axes[0]], t[i][axes[1]] };
  }
  return flat;
}

/** Whether an edge of a counter-clockwise triangle has all of another on its outer side. */
bool EdgeSeparates(const Flat& a, const Flat& b)
{
  for (int i = 0; i < 3; ++i)
  {
    bool outside = true;
    for (int k = 0; k < 3 && outside; ++k)
    {
      outside = CGAL::orientation(a[i], a[(i + 1) % 3], b[k]) != CGAL::POSITIVE;
    }
    if (outside)
    {
      return true;
    }
  }
  return false;
}

/** Whether the interiors of two triangles in one plane meet. */
bool Overlap(const Corners3& a, const Corners3& b)
{
  const std::array<int, 2> axes = ProjectionOf(a);
  const Flat first = Project(a, axes);
  Flat second = Project(b, axes);
  if (CGAL::orientation(second[0], second[1], second[2]) == CGAL::NEGATIVE)
  {
    std::swap(second[1], second[2]);
  }
  return !EdgeSeparates(first, second) && !EdgeSeparates(second, first);
}

} // namespace

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

bool Piercer::IsClose(const Corners4& k) const
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

Contact Piercer::FindContact(const Corners4& k) const
{
  Contact contact;
  if (!this->IsClose(k))
  {
    return contact;
  }
  int above = 0, below = 0, last = 0; // the last one that is not in the plane
  for (int i = 0; i < 4; ++i)
  {
    const CGAL::Orientation side = this->SideOf(k[i]);
    above += side == CGAL::POSITIVE;
    below += side == CGAL::NEGATIVE;
    last = side == CGAL::COPLANAR ? last : i;
  }
  if (above > 0 && below > 0)
  {
    contact.Pierces = !FaceSeparates(this->Corners, k) && !EdgesSeparate(this->Corners, k);
  }
  else if (above + below == 1)
  {
    const auto& [a, b, c] = FaceCorners[last];
    contact.Face = Overlap(this->Corners, { k[a], k[b], k[c] }) ? last : -1;
  }
  return contact;
}

bool OverlapInPlane(const Corners3& a, const Corners3& b)
{
  return std::all_of(b.begin(), b.end(),
           [&](const Inexact::Point_3& p)
           { return SideOfPlane(a[0], a[1], a[2], p) == CGAL::COPLANAR; }) &&
    Overlap(a, b);
}

bool FaceAlike(const Corners3& a, const Corners3& b)
{
  const Flat flat = Project(b, ProjectionOf(a));
  return CGAL::orientation(flat[0], flat[1], flat[2]) == CGAL::POSITIVE;
}
