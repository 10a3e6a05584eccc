// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The faces that cells share with each other and with M.
 */
#ifndef carving_Adjacency_h
#define carving_Adjacency_h

#include "Core/Mesh/Mesh.h"

namespace carving
{

/**
 * Computes `Neighbors` and `Constraints` from `Cells` and `Surface.Facets`. Takes O(n log d) time,
 * where at most d cells meet in a vertex. Returns false if three cells share a face, or two facets
 * are equal.
 */
template <int D>
bool FindAdjacency(Decomposition<D>& mesh);

} // namespace carving

#endif
