// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The points of a mesh that count.
 */
#ifndef carving_CornerPoints_h
#define carving_CornerPoints_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace carving
{

/** The points that are corners of triangles. A mesh may have others, with any coordinates. */
inline std::vector<Point> CornerPoints(const TriangleMesh& mesh)
{
  std::vector<char> isCorner(mesh.Points.size(), 0);
  for (const Triangle& triangle : mesh.Triangles)
  {
    for (const int corner : triangle)
    {
      isCorner[corner] = 1;
    }
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    if (isCorner[i])
    {
      points.push_back(mesh.Points[i]);
    }
  }
  return points;
}

} // namespace carving

#endif
