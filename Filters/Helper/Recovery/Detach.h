// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Takes vertices off M that were put on it. Not in the paper.
 */
#ifndef carving_Detach_h
#define carving_Detach_h

#include "Helper/Enclosing/PiercedMesh.h"

namespace carving::helper
{

/**
 * Removes parts of two triangles that are the same face. On a mesh that does not cross itself, they
 * are where rounding has moved vertices on the common edge of both triangles, and would prevent
 * those from being detached. The caller has to check that DetachAll gives the triangles back.
 */
void RemoveFolds(PiercedMesh& mesh);

/**
 * Detaches vertices that were put inside of triangles of M or of their edges, which are those from
 * index `firstAdded` on. The faces of a triangle are replaced by faces without the vertex, until
 * the triangle is one face again; each space between the triangles gets other vertices off M where
 * it needs them. Few vertices resist, most of them at borders of open surfaces. Where no tetrahedra
 * around a single vertex fill a space, others are searched for, at most `maximumSearches` times; a
 * search takes some milliseconds.
 */
void DetachAll(PiercedMesh& mesh, int firstAdded, int maximumSearches);

} // namespace carving::helper

#endif
