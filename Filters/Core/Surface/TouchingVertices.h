// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The vertices of a level at which parts touch. Not in the paper.
 */
#ifndef carving_TouchingVertices_h
#define carving_TouchingVertices_h

#include "Core/Stream/Level.h"
#include "Core/Surface/Manifold.h"

namespace carving
{

/**
 * The number of vertices of a level that cannot move outward because another part of the solid
 * touches them there, in the same part of the exterior. `cut` is the level cut into manifolds.
 *
 * Not every copy of a point is such a vertex. Where two pits touch, from both sides of a thin wall,
 * each copy has a part of the exterior of its own, into which it can move. O(n log n).
 */
int CountTouchingVertices(
  const StoredStream<3>& stream, const Level<3>& level, const ManifoldLevel<3>& cut);

} // namespace carving

#endif
