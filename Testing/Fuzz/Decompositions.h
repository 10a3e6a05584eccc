// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Small decompositions, as the helper program may answer them, drawn from bytes.
 */
#ifndef Decompositions_h
#define Decompositions_h

#include "Bytes.h"
#include "Core/Mesh/Mesh.h"

/**
 * A box of cubes (squares), split into tetrahedra (triangles) and these again at some points, constrained
 * by the boundary of some of its cells, by any other faces, or both, with cells to keep or without.
 */
template <int D>
carving::Decomposition<D> MakeDecomposition(Bytes& bytes);

#endif
