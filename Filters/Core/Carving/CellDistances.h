// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The distances of cells from M and from the initial approximation.
 */
#ifndef carving_CellDistances_h
#define carving_CellDistances_h

#include "Core/Mesh/Mesh.h"
#include "Core/Solid/Classification.h"

#include <vector>

namespace carving
{

/** The distance of each cell's centroid from M; 0 if M is empty. */
template <int D>
std::vector<double> MeasureDistances(const Decomposition<D>& mesh, int threads);

/**
 * The depth of each cell as a distance (section 5.3): that of its centroid from the surface of the
 * initial approximation. The distance is at least a billionth of M's diagonal, since priorities are
 * divided by it.
 */
template <int D>
std::vector<double> MeasureDepths(
  const Decomposition<D>& mesh, const Classification& regions, int threads);

} // namespace carving

#endif
