// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The priority measures of section 4: how much a cell (a tetrahedron; in the plane, a triangle)
 * matters.
 */
#ifndef carving_Priority_h
#define carving_Priority_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace carving
{

enum class PriorityMeasure : int
{
  LongestEdge = 0, ///< l, the length of the longest edge
  Volume = 1,      ///< v, the volume or area
  Circumradius =
    2, ///< r, the radius of the circumscribed sphere or circle, at most the hull's diagonal
  EdgeVolume = 3,  ///< the geometric mean of l and v as a length
  EdgeDistance = 4 ///< cbrt(l d^2), d being the distance of the centroid from M; not in the paper
};

/**
 * The measure q of every cell, regardless of depth. Finite and not negative. The result does not
 * depend on `threads`.
 */
template <int D>
std::vector<double> ComputePriorities(
  const Decomposition<D>& mesh, PriorityMeasure measure, int threads = 1);

/**
 * A priority as a length: l, the D-th root of v, 2 r, or the value of EdgeVolume or EdgeDistance
 * itself. Not in the paper.
 */
template <int D>
double PriorityAsLength(double priority, PriorityMeasure measure);

} // namespace carving

#endif
