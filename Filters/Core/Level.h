// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One approximation of a stream, written out as a surface.
 */
#ifndef carving_Level_h
#define carving_Level_h

#include "Carver.h"
#include "Mesh.h"

#include <vector>

namespace carving
{

/**
 * The boundary of the solid and the tetrahedra that are not yet carved, oriented outward, and the
 * folds (triangles of M with the exterior on both sides) once each, oriented as M has them.
 *
 * Per triangle: its corners as indices into the tetrahedralization's points, the triangle of M that
 * it is (-1: carved), and the tetrahedron behind it (-1: none, it is a fold).
 */
struct Level
{
  std::vector<Triangle> Triangles;
  std::vector<int> Constraints;
  std::vector<int> CellsBehind;
};

/** C_step, 0 <= step <= stream.LastStep(). */
Level ExtractLevel(const Tetrahedralization& mesh, const Stream& stream, int step);

} // namespace carving

#endif
