// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_HalveKept_h
#define carving_HalveKept_h

#include "Helper/Enclosing/PiercedMesh.h"
#include "Helper/Enclosing/SurfaceDistance.h"

#include <functional>

namespace carving::helper
{

/**
 * Halves pierced tetrahedra at their longest edges until every exposed face is within `tolerance`
 * of M, or until `maximumPoints` have been added. The longest edges come first. Where rounding
 * leaves no room for a vertex, a face stays as far as it is. Returns the number of points added,
 * which does not depend on `threads`.
 */
std::size_t HalveKept(PiercedMesh& mesh, const SurfaceDistance& distance, double tolerance,
  std::size_t maximumPoints, int threads, const std::function<bool(double)>& progress);

} // namespace carving::helper

#endif
