// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Two triangles in one plane, compared exactly. Each must have an area.
 */
#ifndef carving_CoplanarTriangles_h
#define carving_CoplanarTriangles_h

#include "Helper/Base/Kernels.h"

namespace carving::helper
{

/** Whether the interiors of the triangles intersect. */
bool Overlap(const Corners3& a, const Corners3& b);

/**
 * Whether the triangles face the same way. Where `b` is off the plane of `a` by a rounding, a
 * projection decides.
 */
bool FaceAlike(const Corners3& a, const Corners3& b);

} // namespace carving::helper

#endif
