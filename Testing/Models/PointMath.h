// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The vector operations that models need besides those of the core.
 */
#ifndef PointMath_h
#define PointMath_h

#include "Core/Mesh/Vector.h"

#include <cmath>

namespace models
{

using carving::Point;
using carving::operator-;

const double Pi = std::acos(-1.0);
/** Any number of multiples of this angle is spread evenly around a circle. */
const double GoldenAngle = Pi * (3.0 - std::sqrt(5.0));

inline Point operator+(const Point& a, const Point& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Point operator*(double s, const Point& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}

inline Point Normalized(const Point& p)
{
  const double length = carving::Length(p);
  return { p[0] / length, p[1] / length, p[2] / length };
}

inline double Distance(const Point& a, const Point& b)
{
  return carving::Length(b - a);
}

} // namespace models

#endif
