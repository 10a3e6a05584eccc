// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Small decompositions, as the helper program may return them, drawn from bytes.
 */
#ifndef Decompositions_h
#define Decompositions_h

#include "Bytes.h"
#include "Core/Mesh/Mesh.h"

/**
 * A box of cubes (squares), split into tetrahedra (triangles), which are split again at some
 * points. The boundary of some cells, other faces, or both are constraints, and some cells may be
 * kept.
 */
template <int D>
carving::Decomposition<D> MakeDecomposition(Bytes& bytes);

#endif
