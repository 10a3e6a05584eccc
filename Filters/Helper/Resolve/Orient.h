// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Orient_h
#define carving_Orient_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/**
 * Orients the triangles of closed parts alike: winding numbers are meaningless where some
 * triangles are turned. Two triangles belong to a part if they share an edge that no other
 * triangle has. The orientation with less area in a part is turned: the signed multiplicities
 * change sign. A part stays as it is if it is open, since two parts that touch can share edges
 * where neither is closed, and if it has one side. The mesh has to be clean. Not in the paper.
 */
void OrientAlike(ResolvedMesh& mesh);

} // namespace carving::helper

#endif
