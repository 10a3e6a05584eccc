// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Orient_h
#define carving_Orient_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/**
 * Orients triangles alike that share an edge which no other triangle has, since winding numbers
 * would make no sense of some turned ones. Of triangles that are joined in this way, those of one
 * orientation that have less area are turned: their signed multiplicities change sign. A surface
 * with one side stays as it is. The mesh has to be clean. Not in the paper.
 */
void OrientAlike(ResolvedMesh& mesh);

} // namespace carving::helper

#endif
