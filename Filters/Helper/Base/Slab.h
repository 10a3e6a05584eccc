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
    return this->Overlaps(LeastProduct(this->Normal, box), GreatestProduct(this->Normal, box));
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
