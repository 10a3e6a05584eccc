// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Pierce.h"

#include <CGAL/Filtered_predicate.h>

#include <algorithm>
#include <cmath>

using carving::FaceCorners;

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

bool FaceSeparates(const Corners3& t, const Corners4& k)
{
  for (const auto& f : FaceCorners)
  {
    bool outside = true;
    for (int i = 0; i < 3 && outside; ++i)
    {
      // Corners that see a face counter-clockwise are in front of it.
      outside = SideOfPlane(k[f[0]], k[f[1]], k[f[2]], t[i]) != CGAL::NEGATIVE;
    }
    if (outside)
    {
      return true;
    }
  }
  return false;
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

/**
 * The same in doubles where rounding cannot turn the sign: the error of a determinant of differences is
 * below Bound times the product of the columns' largest entries, by some three times.
 */
bool SideInDoubles(const Inexact::Point_3& p, const Inexact::Point_3& q, const Inexact::Point_3& a,
  const Inexact::Point_3& b, const Inexact::Point_3& x, CGAL::Orientation& side)
{
  constexpr double Bound = 1.5e-14, Tiny = 1e-90, Huge = 1e90; // neither under- nor overflow
  double u[3] = {}, v[3] = {}, w[3] = {}, mostU = 0.0, mostV = 0.0, mostW = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    u[i] = q[i] - p[i];
    v[i] = b[i] - a[i];
    w[i] = x[i] - p[i];
    mostU = std::max(mostU, std::abs(u[i]));
    mostV = std::max(mostV, std::abs(v[i]));
    mostW = std::max(mostW, std::abs(w[i]));
  }
  const double determinant = u[0] * (v[1] * w[2] - v[2] * w[1]) +
    u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  side = determinant > 0.0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
  return std::min({ mostU, mostV, mostW }) > Tiny && std::max({ mostU, mostV, mostW }) < Huge &&
    std::abs(determinant) > Bound * mostU * mostV * mostW;
}

CGAL::Orientation Side(const Inexact::Point_3& p, const Inexact::Point_3& q,
  const Inexact::Point_3& a, const Inexact::Point_3& b, const Inexact::Point_3& x)
{
  const auto isOf = [&](const Inexact::Point_3& c) { return c == p || c == q || c == x; };
  if (x == p || x == q || (isOf(a) && isOf(b)))
  {
    return CGAL::ZERO;
  }
  CGAL::Orientation side;
  return SideInDoubles(p, q, a, b, x, side) ? side : FilteredSideAlongEdges()(p, q, a, b, x);
}

bool EdgesSeparate(const Corners3& t, const Corners4& k)
{
  for (int e = 0; e < 6; ++e)
  {
    const auto& p = k[Edges[e][0]];
    const auto& q = k[Edges[e][1]];
    for (int i = 0; i < 3; ++i)
    {
      const auto& a = t[i];
      const auto& b = t[(i + 1) % 3];
      const int r = Side(p, q, a, b, k[Others[e][0]]), s = Side(p, q, a, b, k[Others[e][1]]);
      if (r * s < 0 || (r == 0 && s == 0))
      {
        continue; // no plane that supports the tetrahedron, or parallel edges
      }
      const int own = r != 0 ? r : s;
      // The side of a is that of b: the plane is parallel to their edge.
      const bool touches = b == p || b == q;
      if ((touches || own * Side(p, q, a, b, a) <= 0) &&
        own * Side(p, q, a, b, t[(i + 2) % 3]) <= 0)
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

} // namespace

bool Pierces(const Corners3& triangle, const Corners4& tetrahedron)
{
  return !FaceSeparates(triangle, tetrahedron) && !TriangleSeparates(triangle, tetrahedron) &&
    !EdgesSeparate(triangle, tetrahedron);
}

bool OverlapInPlane(const Corners3& a, const Corners3& b)
{
  for (const auto& p : b)
  {
    if (SideOfPlane(a[0], a[1], a[2], p) != CGAL::COPLANAR)
    {
      return false;
    }
  }
  const std::array<int, 2> axes = ProjectionOf(a);
  const Flat first = Project(a, axes);
  Flat second = Project(b, axes);
  if (CGAL::orientation(second[0], second[1], second[2]) == CGAL::NEGATIVE)
  {
    std::swap(second[1], second[2]);
  }
  return !EdgeSeparates(first, second) && !EdgeSeparates(second, first);
}

bool FaceAlike(const Corners3& a, const Corners3& b)
{
  const Flat flat = Project(b, ProjectionOf(a));
  return CGAL::orientation(flat[0], flat[1], flat[2]) == CGAL::POSITIVE;
}
