// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Vector operations on points.
 */
#ifndef carving_Vector_h
#define carving_Vector_h

#include "Core/Mesh/Mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carving
{

inline Point operator-(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point operator+(const Point& a, const Point& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Point operator*(double s, const Point& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}

inline Point operator/(const Point& a, double s)
{
  return { a[0] / s, a[1] / s, a[2] / s };
}

inline double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Length(const Point& a)
{
  return std::sqrt(Dot(a, a));
}

/** The cotangent of the angle at `apex` in a triangle; infinite if that has no area. */
inline double Cotangent(const Point& apex, const Point& a, const Point& b)
{
  const double sine = Length(Cross(a - apex, b - apex));
  return sine > 0.0 ? Dot(a - apex, b - apex) / sine : HUGE_VAL;
}

/** The point a share t of the way from a to b. */
inline Point Between(const Point& a, const Point& b, double t)
{
  return a + t * (b - a);
}

/** The vector from the first point to another for which a measure of the vector is greatest. */
template <class Measure>
Point FarthestFromFirst(const std::vector<Point>& points, const Measure& measure)
{
  const Point& first = points.front();
  return *std::max_element(points.begin(), points.end(),
           [&](const Point& a, const Point& b)
           { return measure(a - first) < measure(b - first); }) -
    first;
}

/** Six times the signed volume of the tetrahedron (a, b, c, d). */
inline double SixVolume(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return Dot(Cross(b - a, c - a), d - a);
}

} // namespace carving

#endif
