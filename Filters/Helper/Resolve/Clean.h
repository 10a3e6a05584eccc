// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Clean_h
#define carving_Clean_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/** The given triangles, not cleaned yet: every triangle is its own source. */
ResolvedMesh AsResolved(const TriangleMesh& given);

/**
 * Merges equal points into the first of them, merges equal triangles into the first of them, and
 * drops triangles whose area is exactly zero and points that no triangle uses. Points and triangles
 * keep their order.
 */
ResolvedMesh Clean(const ResolvedMesh& mesh);

} // namespace carving::helper

#endif
