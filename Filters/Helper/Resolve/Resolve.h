// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Resolve_h
#define carving_Resolve_h

#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Progress.h"

#include <cmath>
#include <string>

/**
 * Splits triangles along their mutual intersections until no two meet other than in a shared vertex
 * or edge. The points of intersection are exact, then rounded to double; since rounding can make
 * new intersections, it looks again until none is left. It gives up where
 * rounding leaves ever more.
 *
 * `mesh` has been cleaned and stays so. `intersectingPairs` is the number of pairs in the given
 * mesh; with more than `maximumPairs` nothing is split. Returns an empty string or why no clean mesh was
 * reached.
 */
std::string Resolve(carving::ResolvedMesh& mesh, int& intersectingPairs,
  const carving::Progress& progress, double maximumPairs = HUGE_VAL);

#endif
