// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The Euler characteristic of every approximation of a stream. Not in the paper.
 */
#ifndef carving_EulerCharacteristics_h
#define carving_EulerCharacteristics_h

#include "Core/Carving/Stream.h"
#include "Core/Mesh/Mesh.h"

#include <vector>

namespace carving
{

/**
 * Per step, V - E + F - T of the closed complex K (in the plane, V - E + F). Linear in the number
 * of cells.
 */
template <int D>
std::vector<int> ComputeEulerCharacteristics(const Decomposition<D>& mesh, const Stream& stream);

} // namespace carving

#endif
