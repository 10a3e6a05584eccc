// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * A mesh that the user gives for C0 (section 3.1).
 */
#ifndef carving_InitialSurface_h
#define carving_InitialSurface_h

#include "Core/Mesh/Mesh.h"

#include <string>

/**
 * What keeps a mesh from being an initial approximation, all of it, or an empty string: it must be
 * closed, in one piece, of genus zero and free of self-intersections.
 */
std::string CheckInitialSurface(const carving::TriangleMesh& initial);

/**
 * Adds the triangles of C0 to those of M; its points are new. They are marked in `Multiplicities`, and do not
 * count in `SignedMultiplicities`.
 */
void AddInitialSurface(const carving::TriangleMesh& initial, carving::ResolvedMesh& surface);

/**
 * Removes the tetrahedra outside of C0 and the triangles that are only C0's. Returns an empty string or,
 * if some of M lies outside, an error.
 */
std::string RemoveOutsideOfInitial(carving::Tetrahedralization& mesh);

#endif
