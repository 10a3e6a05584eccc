// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_FillPolygon_h
#define carving_FillPolygon_h

#include "Helper/Recovery/SpaceFilling.h"

#include <vector>

namespace carving::helper
{

/**
 * Triangles that fill a polygon, ear by ear, the best shape first; none if there is no ear. The
 * polygon is flat except for rounding, and counter-clockwise when seen against its normal.
 */
std::vector<VertexTriangle> FillPolygon(
  std::vector<PiercedMesh::Vertex> polygon, const Point& normal);

} // namespace carving::helper

#endif
