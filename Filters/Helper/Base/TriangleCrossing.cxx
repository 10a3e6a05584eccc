// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Base/TriangleCrossing.h"

#include <CGAL/intersections.h>

#include <algorithm>

namespace carving::helper
{
namespace
{

/** Moves the common corners to the front, in the same order. Returns their number. */
int Align(Corners3& a, Corners3& b)
{
  int shared = 0;
  for (int i = 0; i < 3; ++i)
  {
    const auto found = std::find(b.begin() + shared, b.end(), a[i]);
    if (found != b.end())
    {
      std::swap(a[i], a[shared]);
      std::iter_swap(found, b.begin() + shared);
      ++shared;
    }
  }
  return shared;
}

/** Whether two triangles with the same corners have the same orientation. */
bool AreEqual(const Corners3& a, const Corners3& b)
{
  const auto first = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return b[(first + 1) % 3] == a[1];
}

} // namespace

bool TrianglesCross(Corners3 a, Corners3 b)
{
  const Corners3 c = a, d = b;
  switch (Align(a, b))
  {
    case 0:
      return CGAL::do_intersect(
        Inexact::Triangle_3(a[0], a[1], a[2]), Inexact::Triangle_3(b[0], b[1], b[2]));
    case 1:
    {
      // The intersection is convex: it is more than the corner if and only if the edge opposite to
      // the corner in one triangle meets the other triangle.
      const auto side = CGAL::orientation(a[0], a[1], a[2], b[1]);
      if (side != CGAL::COPLANAR && side == CGAL::orientation(a[0], a[1], a[2], b[2]))
      {
        return false;
      }
      return CGAL::do_intersect(
               Inexact::Segment_3(a[1], a[2]), Inexact::Triangle_3(b[0], b[1], b[2])) ||
        CGAL::do_intersect(Inexact::Segment_3(b[1], b[2]), Inexact::Triangle_3(a[0], a[1], a[2]));
    }
    case 2:
      return CGAL::coplanar(a[0], a[1], a[2], b[2]) &&
        CGAL::coplanar_orientation(a[0], a[1], a[2], b[2]) == CGAL::POSITIVE;
    default:
      return AreEqual(c, d);
  }
}

} // namespace carving::helper
