// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The triangles of M among the faces of cells.
 */
#ifndef carving_FindConstraints_h
#define carving_FindConstraints_h

#include "Core/Mesh/Mesh.h"

#include <cstddef>

namespace carving::helper
{

/**
 * Sets `Constraints` from `Surface` and the cells: the triangle of M that each face is, or -1.
 * Returns the number of triangles that are no face, or two.
 */
std::size_t FindConstraints(Tetrahedralization& result);

} // namespace carving::helper

#endif
