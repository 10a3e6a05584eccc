// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Resolve_h
#define carving_Resolve_h

#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Progress.h"
#include "Helper/Resolve/Intersections.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace carving::helper
{

/**
 * Splits triangles along their mutual intersections until any two meet only in a shared vertex or
 * edge. Points of intersection are exact, then rounded to doubles. Since rounding can create new
 * intersections, rounds of splitting follow until none is left. Resolving gives up after a round
 * that creates more than it removes.
 *
 * `mesh` has been cleaned and stays clean. `intersectingPairs` is set to the number of intersecting
 * pairs in the given mesh. Nothing is split if it exceeds `maximumPairs`, unless many of the
 * triangles lie on each other, or reaches MostIntersections. Pairs are counted only as far as that
 * matters. Returns an empty string, or why intersections are left.
 */
std::string Resolve(ResolvedMesh& mesh, int& intersectingPairs, const Progress& progress,
  double maximumPairs = HUGE_VAL);

/** Does the same, given the pairs that intersect (FindIntersections), all if fewer than `most`. */
std::string ResolvePairs(ResolvedMesh& mesh, std::vector<std::pair<int, int>> pairs,
  const Progress& progress, double maximumPairs = HUGE_VAL, std::size_t most = MostIntersections);

/**
 * Does the same to a mesh whose parts touch but for rounding: points, edges and triangles that are
 * within `tolerance` of each other are taken to touch (Weld, Imprint). No point that has a source
 * moves farther than `distance`.
 */
std::string ResolveTouching(ResolvedMesh& mesh, double tolerance, double& distance,
  int& intersectingPairs, const Progress& progress, double maximumPairs = HUGE_VAL);

} // namespace carving::helper

#endif
