// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Pierce.h"

#include "Vector.h"

#include <CGAL/Filtered_predicate.h>

#include <algorithm>
#include <cmath>

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

/** From one point to another in doubles; its largest entry is 0 just if they are equal. */
struct Difference
{
  Point Along;
  double Most;

  Difference(const Inexact::Point_3& from, const Inexact::Point_3& to)
    : Along{ to.x() - from.x(), to.y() - from.y(), to.z() - from.z() }
    , Most(
        std::max({ std::abs(this->Along[0]), std::abs(this->Along[1]), std::abs(this->Along[2]) }))
  {
  }
};

/** Two differences, which may be asked for their determinant with others. */
class Planar
{
public:
  Planar(const Difference& u, const Difference& v)
    : Normal(Cross(u.Along, v.Along))
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
    const double determinant = Dot(this->Normal, w.Along);
    side = determinant > 0.0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
    return this->Usable && w.Most > Tiny && w.Most < Huge &&
      std::abs(determinant) > this->Limit * w.Most;
  }

private:
  static constexpr double Bound = 1.5e-14, Tiny = 1e-90, Huge = 1e90; // neither under- nor overflow
  Point Normal;
  double Limit;
  bool Usable;
};

/** Whether a triangle may meet a tetrahedron as far as their bounding boxes can tell. */
bool AreClose(const Corners3& corners, const Corners4& k)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto [least, most] = std::minmax({ corners[0][i], corners[1][i], corners[2][i] });
    const auto [lower, upper] = std::minmax({ k[0][i], k[1][i], k[2][i], k[3][i] });
    const bool apart =
      least == most ? least > upper || most < lower : least >= upper || most <= lower;
    if (apart)
    {
      return false;
    }
  }
  return true;
}

/** A face of the tetrahedron that has all of the triangle in front of it or in its plane; -1: none. */
int SeparatingFace(const Corners3& t, const Corners4& k, bool& inPlane)
{
  for (int face = 0; face < 4; ++face)
  {
    const auto& f = FaceCorners[face];
    const Planar plane({ k[f[0]], k[f[1]] }, { k[f[0]], k[f[2]] });
    bool outside = true;
    inPlane = true;
    for (int i = 0; i < 3 && outside; ++i)
    {
      CGAL::Orientation side;
      if (!plane.FindSide({ k[f[0]], t[i] }, side))
      {
        side = SideOfPlane(k[f[0]], k[f[1]], k[f[2]], t[i]);
      }
      // Corners that see a face counter-clockwise are in front of it.
      outside = side != CGAL::NEGATIVE;
      inPlane = inPlane && side == CGAL::COPLANAR;
    }
    if (outside)
    {
      return face;
    }
  }
  return -1;
}

bool TriangleSeparates(const Corners3& t, const Corners4& k)
{
  bool above = true, below = true;
  for (int i = 0; i < 4 && (above || below); ++i)
  {
    const CGAL::Orientation side = SideOfPlane(t[0], t[1], t[2], k[i]);
    above = above && side != CGAL::NEGATIVE;
    below = below && side != CGAL::POSITIVE;
  }
  return above || below;
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
      const Planar planes(edge, ofTriangle[i]);
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

Contact FindContact(const Corners3& triangle, const Corners4& k)
{
  Contact contact;
  if (!AreClose(triangle, k))
  {
    return contact;
  }
  bool inPlane = false;
  const int face = SeparatingFace(triangle, k, inPlane);
  if (face < 0)
  {
    contact.Pierces = !TriangleSeparates(triangle, k) && !EdgesSeparate(triangle, k);
  }
  else if (inPlane)
  {
    const auto& [a, b, c] = FaceCorners[face];
    contact.Face = Overlap(triangle, { k[a], k[b], k[c] }) ? face : -1;
  }
  return contact; // what is in front of one face overlaps no other
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
