// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Recovers the triangles of M that a Delaunay tetrahedralization lacks. Not in the paper.
 */
#ifndef carving_Recover_h
#define carving_Recover_h

#include "Helper/Enclosing/PiercedMesh.h"

#include <functional>

namespace carving::helper
{

/**
 * Makes faces of the parts of M, one after the other: the tetrahedra that a part meets are removed,
 * and the cavity is filled again around the part. The mesh is valid at any time, and a part that is
 * a face stays one. No point is added. At most `steps` comparisons of a triangle with a tetrahedron
 * are made.
 */
void Recover(PiercedMesh& mesh, std::ptrdiff_t steps, const std::function<bool(double)>& progress);

} // namespace carving::helper

#endif
