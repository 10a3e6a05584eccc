// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * M as the surfaces of enclosing mode enclose it. Not in the paper.
 */
#ifndef carving_GatherParts_h
#define carving_GatherParts_h

#include "Core/Mesh/Mesh.h"

namespace carving
{

/**
 * The parts of M that are faces of cells in enclosing mode, and the triangles of M that are not met
 * whole. Empty in exact mode.
 *
 * The points that divide a triangle are rounded, so that levels enclose its parts, but the triangle
 * only up to these roundings. A surface that changes has to be kept around the parts: one around
 * the triangle alone could lose all of the triangle that a rounding has left outside.
 *
 * `parts` is the surface of `result`, which may be stored elsewhere.
 */
ResolvedMesh GatherParts(const Tetrahedralization& result, const ResolvedMesh& parts);

} // namespace carving

#endif
