// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Depth as a distance (section 5.3).
 */
#ifndef InitialDistance_h
#define InitialDistance_h

#include "Core/Mesh/Mesh.h"

#include <vector>

/**
 * Per cell the distance of its centroid from the surface of the initial approximation, at least
 * a billionth of the points' diagonal, so that it can be divided by.
 */
template <int D>
std::vector<double> ComputeInitialDistances(const carving::Decomposition<D>& mesh);

#endif
