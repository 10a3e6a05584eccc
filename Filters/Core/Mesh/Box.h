// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Axis-aligned boxes.
 */
#ifndef carving_Box_h
#define carving_Box_h

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <vector>

namespace carving
{

/** An axis-aligned box, initially empty. */
struct Box
{
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  Point Lower = { Infinity, Infinity, Infinity };
  Point Upper = { -Infinity, -Infinity, -Infinity };

  bool IsEmpty() const
  {
    return this->Lower[0] > this->Upper[0];
  }

  void Add(const Point& p)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Lower[k] = std::min(this->Lower[k], p[k]);
      this->Upper[k] = std::max(this->Upper[k], p[k]);
    }
  }

  void Add(const Box& other)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Lower[k] = std::min(this->Lower[k], other.Lower[k]);
      this->Upper[k] = std::max(this->Upper[k], other.Upper[k]);
    }
  }

  bool Overlaps(const Box& other) const
  {
    return this->Lower[0] <= other.Upper[0] && other.Lower[0] <= this->Upper[0] &&
      this->Lower[1] <= other.Upper[1] && other.Lower[1] <= this->Upper[1] &&
      this->Lower[2] <= other.Upper[2] && other.Lower[2] <= this->Upper[2];
  }

  bool Contains(const Box& other) const
  {
    return this->Lower[0] <= other.Lower[0] && other.Upper[0] <= this->Upper[0] &&
      this->Lower[1] <= other.Lower[1] && other.Upper[1] <= this->Upper[1] &&
      this->Lower[2] <= other.Lower[2] && other.Upper[2] <= this->Upper[2];
  }

  double SquaredDistanceTo(const Point& p) const
  {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double outside = std::max({ 0.0, this->Lower[k] - p[k], p[k] - this->Upper[k] });
      sum += outside * outside;
    }
    return sum;
  }
};

/** The smallest box around some points. */
template <class Points>
Box BoxAround(const Points& points)
{
  Box box;
  for (const Point& p : points)
  {
    box.Add(p);
  }
  return box;
}

inline Box BoxAround(std::initializer_list<Point> points)
{
  return BoxAround<std::initializer_list<Point>>(points);
}

/** The box of what two overlapping boxes have in common. */
inline Box Intersection(const Box& a, const Box& b)
{
  Box common;
  for (int k = 0; k < 3; ++k)
  {
    common.Lower[k] = std::max(a.Lower[k], b.Lower[k]);
    common.Upper[k] = std::min(a.Upper[k], b.Upper[k]);
  }
  return common;
}

/** The least scalar product of a vector with a point of a box. */
inline double LeastProduct(const Point& along, const Box& box)
{
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    sum += std::min(along[k] * box.Lower[k], along[k] * box.Upper[k]);
  }
  return sum;
}

/** The greatest scalar product of a vector with a point of a box. */
inline double GreatestProduct(const Point& along, const Box& box)
{
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    sum += std::max(along[k] * box.Lower[k], along[k] * box.Upper[k]);
  }
  return sum;
}

/** The length of the diagonal of the points' bounding box; 0 without points. */
inline double Diagonal(const std::vector<Point>& points)
{
  const Box box = BoxAround(points);
  return box.IsEmpty() ? 0.0 : Length(box.Upper - box.Lower);
}

} // namespace carving

#endif
