// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which cells share a face, and which faces lie on M.
 */
#ifndef carving_Adjacency_h
#define carving_Adjacency_h

#include "Core/Mesh/Mesh.h"

namespace carving
{

/**
 * Finds `Neighbors` and `Constraints` from `Cells` and `Surface.Facets`, in time linear in their number
 * unless vertices have very many cells. Returns false if three cells share a face.
 */
template <int D>
bool FindAdjacency(Decomposition<D>& mesh);

} // namespace carving

#endif
