// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The carving itself: in which order the tetrahedra of the complement disappear.
 */
#ifndef carving_Carver_h
#define carving_Carver_h

#include "Core/Carving/Priority.h"
#include "Core/Carving/Stream.h"
#include "Core/Mesh/BettiNumbers.h"
#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Progress.h"
#include "Core/Solid/Classification.h"

#include <vector>

namespace carving
{

struct CarveOptions
{
  PriorityMeasure Measure = PriorityMeasure::LongestEdge;
  /** dp >= 0 of equation (2): a priority is divided by the depth to the power of dp. */
  double DepthExponent = 0.0;
  /**
   * The depth d of every tetrahedron, above 0. Empty: its level in the hierarchy of section 5.3,
   * 1 on C0, one more than the neighbor whose carving made it carvable elsewhere.
   */
  std::vector<double> Depths;
  /**
   * bp >= 0 of section 5.4: a step carves all tetrahedra whose centroid lies within this distance of
   * the popped one's and that a walk among those reaches. 0: the popped one alone.
   */
  double BreadthRadius = 0.0;
  /** Exposed neighbors of a carved tetrahedron follow in the same step (section 3.4). */
  bool CarveExposed = true;
  /** Voids are opened, each at its tetrahedron of highest priority (section 3). */
  bool CarveVoids = true;
  /**
   * The most components, tunnels and voids that any approximation may have, as a closed complex: of M, the
   * solid and what is not carved. Negative: no limit. C0 has one component, so that a limit of 0 means 1.
   */
  BettiNumbers Budget = { -1, -1, -1 };
};

/**
 * Carves the complement, highest priority first, ties by the smaller tetrahedron index. Exposed
 * tetrahedra are those of degree above one.
 *
 * With a budget, a tetrahedron that would exceed it is put aside, also if it is one of many in a step, until
 * what other cells hold of its boundary, or what is left of the budget, has become another. In the end none
 * is left that could be carved alone. Where no budget is exceeded the stream is the same as without.
 *
 * Parts that touch in an edge or a vertex are one in K, but may not be on a level that is cut into manifolds.
 * In space components therefore have to stay within the budget either way, as K has them and as the
 * tetrahedra that are left have them when they are glued at faces only.
 *
 * Returns false when `progress` asked to stop; `stream` is then incomplete.
 */
template <int D>
bool Carve(const Decomposition<D>& mesh, const Classification& regions, const CarveOptions& options,
  Stream& stream, const Progress& progress = {});

/** How many cells are left that carving would have taken if it had no budget. */
int CountLeft(const Classification& regions, const CarveOptions& options, const Stream& stream);

} // namespace carving

#endif
