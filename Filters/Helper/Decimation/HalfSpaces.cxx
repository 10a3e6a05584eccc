// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/HalfSpaces.h"

#include <cmath>
#include <limits>

namespace carving::helper
{
namespace
{

/** Coefficients below this are those of a constraint that the remaining freedom cannot change. */
constexpr double Parallel = 1e-12;

/**
 * The least point of the quadric on the line p + t d within the half-spaces before `count`. Returns
 * false if the line has no point within them.
 */
bool MinimizeOnLine(const Quadric& q, const std::vector<HalfSpace>& halfSpaces, std::size_t count,
  const Point& p, const Point& d, double tolerance, Point& least)
{
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double slope = Dot(halfSpaces[i].Normal, d);
    const double gap = halfSpaces[i].Offset - Dot(halfSpaces[i].Normal, p);
    if (slope > Parallel)
    {
      low = std::max(low, gap / slope);
    }
    else if (slope < -Parallel)
    {
      high = std::min(high, gap / slope);
    }
    else if (gap > tolerance)
    {
      return false;
    }
  }
  if (low > high)
  {
    return false;
  }
  const Point a = q.TimesA(d);
  const double curvature = Dot(a, d), slope = Dot(a, p) + Dot(q.B, d);
  const double t = std::min(std::max(-slope / curvature, low), high);
  least = { p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2] };
  return true;
}

bool IsViolated(const HalfSpace& halfSpace, const Point& x, double tolerance)
{
  return Dot(halfSpace.Normal, x) < halfSpace.Offset - tolerance;
}

/** On the plane that bounds half-space number `count`, subject to those before it. */
bool MinimizeOnPlane(const Quadric& q, const std::vector<HalfSpace>& halfSpaces, std::size_t count,
  double tolerance, Point& least)
{
  const Point& n = halfSpaces[count].Normal;
  const Point p = { halfSpaces[count].Offset * n[0], halfSpaces[count].Offset * n[1],
    halfSpaces[count].Offset * n[2] };
  const int smallest = std::abs(n[0]) < std::abs(n[1]) ? (std::abs(n[0]) < std::abs(n[2]) ? 0 : 2)
                                                       : (std::abs(n[1]) < std::abs(n[2]) ? 1 : 2);
  Point axis = {};
  axis[smallest] = 1.0;
  Point u = Cross(n, axis);
  const double length = Length(u);
  for (double& x : u)
  {
    x /= length;
  }
  const Point v = Cross(n, u);
  const Point au = q.TimesA(u), av = q.TimesA(v), ap = q.TimesA(p);
  const double uu = Dot(u, au), uv = Dot(u, av), vv = Dot(v, av);
  const double bu = Dot(u, ap) + Dot(u, q.B), bv = Dot(v, ap) + Dot(v, q.B);
  const double determinant = uu * vv - uv * uv;
  const double s = (-bu * vv + bv * uv) / determinant, t = (-bv * uu + bu * uv) / determinant;
  const auto at = [&](double x, double y)
  {
    return Point{ p[0] + x * u[0] + y * v[0], p[1] + x * u[1] + y * v[1],
      p[2] + x * u[2] + y * v[2] };
  };
  least = at(s, t);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!IsViolated(halfSpaces[i], least, tolerance))
    {
      continue;
    }
    // The line where both planes meet, in coordinates of this one.
    const double nu = Dot(halfSpaces[i].Normal, u), nv = Dot(halfSpaces[i].Normal, v);
    const double squared = nu * nu + nv * nv;
    if (squared < Parallel * Parallel)
    {
      return false;
    }
    const double gap = (halfSpaces[i].Offset - Dot(halfSpaces[i].Normal, p)) / squared;
    const double norm = std::sqrt(squared);
    const Point direction = { (-nv * u[0] + nu * v[0]) / norm, (-nv * u[1] + nu * v[1]) / norm,
      (-nv * u[2] + nu * v[2]) / norm };
    if (!MinimizeOnLine(q, halfSpaces, i, at(gap * nu, gap * nv), direction, tolerance, least))
    {
      return false;
    }
  }
  return true;
}

} // namespace

bool Minimize(const Quadric& q, const std::vector<HalfSpace>& halfSpaces, Point& least)
{
  // Cramer's rule.
  const Point r0 = { q.Xx, q.Xy, q.Xz }, r1 = { q.Xy, q.Yy, q.Yz }, r2 = { q.Xz, q.Yz, q.Zz };
  const Point c12 = Cross(r1, r2), c20 = Cross(r2, r0), c01 = Cross(r0, r1);
  const double determinant = Dot(r0, c12);
  for (int i = 0; i < 3; ++i)
  {
    least[i] = -(q.B[0] * c12[i] + q.B[1] * c20[i] + q.B[2] * c01[i]) / determinant;
  }
  double scale = Length(least);
  for (const HalfSpace& halfSpace : halfSpaces)
  {
    scale = std::max(scale, std::abs(halfSpace.Offset));
  }
  const double tolerance = 1e-15 * scale;
  for (std::size_t i = 0; i < halfSpaces.size(); ++i)
  {
    if (IsViolated(halfSpaces[i], least, tolerance) &&
      !MinimizeOnPlane(q, halfSpaces, i, tolerance, least))
    {
      return false;
    }
  }
  return std::isfinite(least[0] + least[1] + least[2]);
}

} // namespace carving::helper
