// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks of a PiercedMesh that is changed step by step.
 */
#ifndef carving_PiercedMeshCheck_h
#define carving_PiercedMeshCheck_h

#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/PiercedMesh.h"

#include <gtest/gtest.h>

namespace carving::helper
{

inline bool Proceed(double)
{
  return true;
}

/** Six times the volume of all cells, which must be oriented positively. Exact but for sums. */
inline double SixVolumeOf(const PiercedMesh& mesh)
{
  double sum = 0.0;
  for (const PiercedMesh::Cell cell : mesh.GetDelaunay().finite_cell_handles())
  {
    const auto& [a, b, c, d] = CornersOf(cell);
    EXPECT_EQ(CGAL::orientation(a, b, c, d), CGAL::POSITIVE);
    sum += SixVolume(ToPoint(a), ToPoint(b), ToPoint(c), ToPoint(d));
  }
  return sum;
}

} // namespace carving::helper

#endif
