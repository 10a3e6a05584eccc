// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The shape of a tetrahedron of which one corner is moved.
 */
#ifndef carving_CellShape_h
#define carving_CellShape_h

#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/PiercedMesh.h"

#include <cfloat>
#include <cmath>

namespace carving::helper
{

inline Corners4 MovedCorners(const PiercedMesh::Cell& cell, int corner, const Inexact::Point_3& p)
{
  Corners4 k = CornersOf(cell);
  k[corner] = p;
  return k;
}

/** Whether a cell is oriented positively with another point in the place of a corner. */
inline bool IsPositive(const PiercedMesh::Cell& cell, int corner, const Inexact::Point_3& p)
{
  const Corners4 k = MovedCorners(cell, corner, p);
  return CGAL::orientation(k[0], k[1], k[2], k[3]) == CGAL::POSITIVE;
}

/** Six times the signed volume. */
inline double SixVolumeOf(const Corners4& k)
{
  return SixVolume(ToPoint(k[0]), ToPoint(k[1]), ToPoint(k[2]), ToPoint(k[3]));
}

/**
 * Six times the volume of a tetrahedron as a share of the cube of its longest edge, at least
 * DBL_MIN.
 */
inline double QualityOf(const Corners4& k)
{
  double longest = 0.0; // squared
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      longest = std::max(longest, CGAL::to_double((k[i] - k[j]).squared_length()));
    }
  }
  return std::max(SixVolumeOf(k) / (longest * std::sqrt(longest)), DBL_MIN);
}

} // namespace carving::helper

#endif
