// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_WriteCells_h
#define carving_WriteCells_h

#include "Helper/Enclosing/PiercedMesh.h"

namespace carving::helper
{

/**
 * Writes all points, and the tetrahedra in the order of the mesh's finite cells, without
 * constraints. Numbers the cells in their `Index`. The sources of further points are -1.
 */
void WriteCells(const PiercedMesh& mesh, Tetrahedralization& result);

} // namespace carving::helper

#endif
