// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Pieces that split off and hold nothing of M. Not in the paper, where each vertex is one of M's.
 */
#ifndef carving_LoosePieces_h
#define carving_LoosePieces_h

#include "Core/Carving/Stream.h"
#include "Core/Mesh/Mesh.h"

namespace carving
{

/**
 * Moves the cells of each component of an approximation that touches neither M nor a cell that
 * stays to the step that splits the component off: later, the component would vanish, and the
 * number of components would fall. Steps that lose all their cells are dropped.
 */
template <int D>
void CarveLoosePieces(const Decomposition<D>& mesh, Stream& stream);

} // namespace carving

#endif
