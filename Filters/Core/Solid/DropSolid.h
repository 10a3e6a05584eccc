// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The decomposition of the complement of M alone.
 */
#ifndef carving_DropSolid_h
#define carving_DropSolid_h

#include "Core/Mesh/Mesh.h"
#include "Core/Solid/Classification.h"

namespace carving
{

/**
 * Removes the tetrahedra of the solid, about half of all, in place: carving without a budget needs
 * the complement only. The remaining tetrahedra keep their order. Their faces on the solid get the
 * neighbor Solid. Fills `SolidRegions` of the regions. Not for enclosing mode, where the solid and
 * kept tetrahedra may share faces that are not of M.
 */
void DropSolid(Tetrahedralization& mesh, Classification& regions);

} // namespace carving

#endif
