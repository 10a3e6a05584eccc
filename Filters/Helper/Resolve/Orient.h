// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Orient_h
#define carving_Orient_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/**
 * Orients the triangles of closed parts alike, since winding numbers would make no sense of some
 * turned ones. Two triangles belong to a part if they share an edge which no other triangle has. Of
 * the triangles of a part, those of one orientation that have less area are turned: their signed
 * multiplicities change sign. A part stays as it is if it is open, since two parts that touch can
 * share edges where neither is closed, and if it has one side. The mesh has to be clean. Not in the
 * paper.
 */
void OrientAlike(ResolvedMesh& mesh);

} // namespace carving::helper

#endif
