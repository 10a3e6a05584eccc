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
using carving::operator+;
using carving::operator-;
using carving::operator*;
using carving::operator/;

const double Pi = std::acos(-1.0);
/** Any number of multiples of this angle is spread evenly around a circle. */
const double GoldenAngle = Pi * (3.0 - std::sqrt(5.0));

inline Point Normalized(const Point& p)
{
  return p / carving::Length(p);
}

inline double Distance(const Point& a, const Point& b)
{
  return carving::Length(b - a);
}

} // namespace models

#endif
