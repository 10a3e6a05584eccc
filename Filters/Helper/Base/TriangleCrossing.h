// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Crossings of two triangles, decided exactly.
 */
#ifndef carving_TriangleCrossing_h
#define carving_TriangleCrossing_h

#include "Helper/Base/CoplanarTriangles.h"

namespace carving::helper
{

/**
 * Whether two triangles with area have more in common than corners at the same positions, edges
 * between these, or, with opposite orientation, all corners.
 */
bool TrianglesCross(Corners3 a, Corners3 b);

} // namespace carving::helper

#endif
