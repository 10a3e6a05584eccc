// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Interior_h
#define carving_Interior_h

#include "Core/Mesh/Mesh.h"
#include "Core/Solid/Classification.h"

namespace carving::helper
{

/**
 * Removes the triangles that have solid on both sides by the given rule, which no level shows, and
 * the points that only they use. The multiplicities of the remaining triangles become those of the
 * solid's boundary, so that the same rule finds the same solid. Not in the paper.
 *
 * The mesh has been resolved. Returns the number of removed triangles. It is 0, and the mesh is
 * unchanged, if the mesh is not closed or the solid is ambiguous.
 */
int DropInterior(SolidRule rule, ResolvedMesh& mesh);

} // namespace carving::helper

#endif
