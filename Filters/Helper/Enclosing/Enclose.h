// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The rung that cannot fail: a Delaunay tetrahedralization in which every tetrahedron that M pierces is
 * kept for good.
 */
#ifndef carving_Enclose_h
#define carving_Enclose_h

#include "Core/Mesh/Mesh.h"

#include <functional>
#include <vector>

/**
 * Tetrahedralizes the points of `input`, which has been cleaned and may cross itself, and `further` points
 * of C0; they must not all lie in one plane. Points are added until no tetrahedron that a triangle meets
 * reaches farther from M than `tolerance`, a share of the diagonal of M's bounding box; 0: none are.
 * `Kept` of the result marks these tetrahedra; `Surface` has the faces that overlap a triangle in an area,
 * as parts of M; `Unresolved` is the input. Returns the distance to which what is kept reaches from M, to
 * 5 %.
 */
double Enclose(const carving::ResolvedMesh& input, const std::vector<carving::Point>& further,
  double tolerance, const std::function<bool(double)>& progress,
  carving::Tetrahedralization& result);

#endif
