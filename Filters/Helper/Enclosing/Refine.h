// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Enclosing more tightly: points are put on M where pierced tetrahedra reach too far from it.
 */
#ifndef carving_Refine_h
#define carving_Refine_h

#include "Helper/Enclosing/PiercedMesh.h"
#include "Helper/Enclosing/SurfaceDistance.h"

#include <functional>

/**
 * Adds points until no pierced tetrahedron shows a face that is farther than `tolerance` from M, or
 * `maximumPoints` have been added. They lie on M (up to rounding), or aside of it where M has enough.
 */
void Refine(PiercedMesh& mesh, const SurfaceDistance& distance, double tolerance,
  std::size_t maximumPoints, const std::function<bool(double)>& progress);

/**
 * The distance from M to which pierced tetrahedra reach, to 5 %, or `negligible` where it is less; 0 if
 * there are none.
 */
double Reach(const PiercedMesh& mesh, const SurfaceDistance& distance, double negligible);

#endif
