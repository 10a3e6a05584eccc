// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Tightens the enclosure: adds points on M where pierced tetrahedra reach too far from it.
 */
#ifndef carving_Refine_h
#define carving_Refine_h

#include "Helper/Enclosing/PiercedMesh.h"
#include "Helper/Enclosing/SurfaceDistance.h"

#include <functional>

namespace carving::helper
{

/**
 * Adds points until every exposed face of a pierced tetrahedron is within `tolerance` of M, or
 * until `maximumPoints` have been added, or until the work is out of proportion to them. A face is
 * exposed if the tetrahedron behind it is not pierced. Points lie on M, except for rounding, or off
 * M where points on M are dense enough.
 */
void Refine(PiercedMesh& mesh, const SurfaceDistance& distance, double tolerance,
  std::size_t maximumPoints, const std::function<bool(double)>& progress);

} // namespace carving::helper

#endif
