// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The carving itself (sections 3 to 5): tetrahedra of the complement disappear, highest priority
 * first.
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
  int Threads = 1; ///< for the measure; the stream does not depend on it
  /**
   * dp >= 0 of equation (2), section 5.3: the measure is divided by the depth to the power of dp.
   */
  double DepthExponent = 0.0;
  /**
   * The depth d > 0 of every tetrahedron. Empty: its level in the hierarchy of section 5.3, which
   * is 1 on C0 and elsewhere one more than that of the neighbor whose removal made the tetrahedron
   * carvable.
   */
  std::vector<double> Depths;
  /**
   * bp >= 0 of section 5.4, a length: a step carves all tetrahedra whose centroids lie within this
   * distance of the popped one's and that a walk through such tetrahedra reaches. 0: the popped one
   * alone.
   */
  double BreadthRadius = 0.0;
  /** Carve the exposed neighbors of a carved tetrahedron in the same step (section 3.4). */
  bool CarveExposed = true;
  /** Open each void at its tetrahedron of highest priority (section 3). */
  bool CarveVoids = true;
  /**
   * The most components, tunnels and voids that the closed complex K of any approximation may have.
   * Negative: no limit. C0 has one component, so that a limit of 0 components means 1. Budgets are
   * not in the paper.
   */
  BettiNumbers Budget = { -1, -1, -1 };
};

/**
 * Carves the complement, highest priority first. The smaller tetrahedron index breaks ties.
 *
 * A budget defers each tetrahedron whose removal would exceed it, also in the middle of a step,
 * until its neighborhood or the room in the budget has changed. In the end no remaining tetrahedron
 * could be removed alone within the budget. A budget that is never exceeded does not change the
 * stream.
 *
 * Parts that touch in an edge or a vertex are connected in K, but may be apart on a level that is
 * cut into manifolds. In space, a budget of components therefore limits both the components of K
 * and those of the remaining tetrahedra connected through faces only.
 *
 * Returns false if `progress` asked to stop; `stream` is then incomplete.
 */
template <int D>
bool Carve(const Decomposition<D>& mesh, const Classification& regions, const CarveOptions& options,
  Stream& stream, const Progress& progress = {});

/** The number of remaining cells that would have been carved without a budget. */
int CountLeft(const Classification& regions, const CarveOptions& options, const Stream& stream);

} // namespace carving

#endif
