// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The depth of cells as a distance (section 5.3).
 */
#ifndef InitialDistance_h
#define InitialDistance_h

#include "Core/Mesh/Mesh.h"

#include <vector>

/**
 * For each cell, the distance of its centroid from the surface of the initial approximation. The
 * distance is at least a billionth of the points' diagonal, since priorities are divided by it.
 */
template <int D>
std::vector<double> ComputeInitialDistances(const carving::Decomposition<D>& mesh);

#endif
