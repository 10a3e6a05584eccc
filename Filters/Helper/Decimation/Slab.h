// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The space between two parallel planes.
 */
#ifndef carving_Slab_h
#define carving_Slab_h

#include "Core/Mesh/Box.h"

namespace carving::helper
{

struct Slab
{
  Point Normal;
  double Lower, Upper; ///< of the scalar product with Normal

  bool Overlaps(const Box& box) const
  {
    double lower = 0.0, upper = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double x = this->Normal[k] * box.Lower[k], y = this->Normal[k] * box.Upper[k];
      lower += std::min(x, y);
      upper += std::max(x, y);
    }
    return this->Overlaps(lower, upper);
  }

  bool Overlaps(const std::array<Point, 3>& triangle) const
  {
    const double a = Dot(this->Normal, triangle[0]), b = Dot(this->Normal, triangle[1]),
                 c = Dot(this->Normal, triangle[2]);
    return this->Overlaps(std::min({ a, b, c }), std::max({ a, b, c }));
  }

private:
  /** True if a product is not a number, since normals of huge triangles overflow. */
  bool Overlaps(double lower, double upper) const
  {
    return !(lower > this->Upper || upper < this->Lower);
  }
};

} // namespace carving::helper

#endif
