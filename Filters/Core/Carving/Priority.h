// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How much a cell (a tetrahedron, in the plane a triangle) matters: the measures of section 4.
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
  EdgeVolume = 3 ///< the geometric mean of l and v as a length
};

/** q of every cell, before depth is taken into account. Finite and not negative. */
template <int D>
std::vector<double> ComputePriorities(const Decomposition<D>& mesh, PriorityMeasure measure);

/** A priority as a length: l, the root of v of order D, 2 r, or what EdgeVolume is. */
template <int D>
double PriorityAsLength(double priority, PriorityMeasure measure);

} // namespace carving

#endif
