// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Corners and sizes of cells.
 */
#ifndef carving_CellGeometry_h
#define carving_CellGeometry_h

#include "Core/Mesh/Vector.h"

#include <algorithm>

namespace carving
{

template <int D>
using CellCorners = std::array<Point, D + 1>;

template <int D>
CellCorners<D> CornersOfCell(const Decomposition<D>& mesh, int cell)
{
  CellCorners<D> corners;
  for (int i = 0; i <= D; ++i)
  {
    corners[i] = mesh.Surface.Points[mesh.Cells[cell][i]];
  }
  return corners;
}

/** The volume of a tetrahedron; 0 where rounding makes it negative. */
inline double Size(const CellCorners<3>& p)
{
  return std::max(0.0, SixVolume(p[0], p[1], p[2], p[3]) / 6.0);
}

/** The area of a triangle. */
inline double Size(const CellCorners<2>& p)
{
  return Length(Cross(p[1] - p[0], p[2] - p[0])) / 2.0;
}

} // namespace carving

#endif
