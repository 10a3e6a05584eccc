// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Bounds that fit long and thin triangles in any direction.
 */
#ifndef carving_FittedBounds_h
#define carving_FittedBounds_h

#include "Helper/Base/Slab.h"

#include <cmath>
#include <limits>

namespace carving::helper
{

/**
 * The bounding box of a few points, and two slabs around them: along the plane of the first three,
 * and along the longest edge of these. Of the bounding box of a long and thin triangle that is
 * parallel to no axis, the triangle fills hardly anything.
 */
template <std::size_t NumberOfPoints>
class FittedBounds
{
public:
  explicit FittedBounds(const std::array<Point, NumberOfPoints>& points)
    : Bounds(BoxAround(points))
  {
    const Point &a = points[0], &b = points[1], &c = points[2];
    const Point normal = Cross(b - a, c - a);
    Point longest = b - a;
    for (const Point& edge : { c - b, a - c })
    {
      longest = Dot(edge, edge) > Dot(longest, longest) ? edge : longest;
    }
    this->Slabs = { this->MakeSlab(normal, points),
      this->MakeSlab(Cross(normal, longest), points) };
  }

  const Box& GetBox() const
  {
    return this->Bounds;
  }

  /** Never misses an overlap by rounding. */
  bool Overlaps(const Box& box) const
  {
    if (!this->Bounds.Overlaps(box))
    {
      return false;
    }
    const Box common = Intersection(this->Bounds, box);
    return this->Slabs[0].Overlaps(common) && this->Slabs[1].Overlaps(common);
  }

private:
  /** The slab is wider by more than the rounding errors of the scalar products. */
  Slab MakeSlab(const Point& normal, const std::array<Point, NumberOfPoints>& points) const
  {
    constexpr double rounding = 2e-15, underflow = std::numeric_limits<double>::min();
    Slab slab = { normal, Box::Infinity, -Box::Infinity };
    double size = 0.0; // no product within the bounds is greater
    for (int k = 0; k < 3; ++k)
    {
      size += std::abs(normal[k]) *
        std::max(std::abs(this->Bounds.Lower[k]), std::abs(this->Bounds.Upper[k]));
    }
    for (const Point& p : points)
    {
      slab.Lower = std::min(slab.Lower, Dot(normal, p));
      slab.Upper = std::max(slab.Upper, Dot(normal, p));
    }
    slab.Lower -= rounding * size + underflow;
    slab.Upper += rounding * size + underflow;
    return slab;
  }

  Box Bounds;
  std::array<Slab, 2> Slabs;
};

} // namespace carving::helper

#endif
