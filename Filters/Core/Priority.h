// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How much a tetrahedron matters: the measures of section 4.
 */
#ifndef carving_Priority_h
#define carving_Priority_h

#include "Mesh.h"

#include <vector>

namespace carving
{

enum class PriorityMeasure : int
{
  LongestEdge = 0,  ///< l, the length of the longest edge
  Volume = 1,       ///< v, the volume
  Circumradius = 2, ///< r, the radius of the circumscribed sphere, at most the hull's diagonal
  EdgeVolume = 3    ///< the geometric mean of l and the cube root of v
};

/** q of every tetrahedron, before depth is taken into account. Finite and not negative. */
std::vector<double> ComputePriorities(const Tetrahedralization& mesh, PriorityMeasure measure);

/** A priority as a length: l, the cube root of v, 2 r, or what EdgeVolume is. */
double PriorityAsLength(double priority, PriorityMeasure measure);

/** The length of the diagonal of the points' bounding box. */
double Diagonal(const std::vector<Point>& points);

} // namespace carving

#endif
