// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Clean_h
#define carving_Clean_h

#include "Core/Mesh/Mesh.h"

/** The given triangles as a mesh to be cleaned: every triangle is its own source. */
carving::ResolvedMesh AsResolved(const carving::TriangleMesh& given);

/**
 * Merges equal points (the first one's source stays), drops points that no triangle uses and
 * triangles of exactly zero area, and merges equal triangles into the first of them. Points and
 * triangles keep their order.
 */
carving::ResolvedMesh Clean(const carving::ResolvedMesh& mesh);

#endif
