// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The rung that cannot fail: a Delaunay tetrahedralization in which every tetrahedron that M pierces is
 * kept for good.
 */
#ifndef carving_Enclose_h
#define carving_Enclose_h

#include "Mesh.h"

#include <functional>
#include <vector>

/**
 * Tetrahedralizes the points of `input`, which has been cleaned and may cross itself, and `further` points
 * of C0; they must not all lie in one plane. `Kept` of the result marks the tetrahedra whose interior a
 * triangle meets; `Surface` has the faces that overlap a triangle in an area, as parts of M; `Unresolved`
 * is the input. Returns the longest edge of what is kept, 0 if nothing is.
 */
double Enclose(const carving::ResolvedMesh& input, const std::vector<carving::Point>& further,
  const std::function<bool(double)>& progress, carving::Tetrahedralization& result);

#endif
