// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * A C0 that the user gives as a mesh (section 3.1).
 */
#ifndef carving_InitialSurface_h
#define carving_InitialSurface_h

#include "Core/Mesh/Mesh.h"

#include <string>

namespace carving::helper
{

/**
 * Checks that a clean mesh can be C0: closed, of one component, of genus zero and free of
 * self-intersections. Returns an empty string, or a message that names every check that fails.
 */
std::string CheckInitialSurface(const ResolvedMesh& mesh);

/**
 * Checks that no point of M is outside a C0 that has passed the check. To be called first, since
 * TetGen may fail where M and C0 cross. Returns an empty string, or an error.
 */
std::string CheckPointsWithin(const ResolvedMesh& initial, const ResolvedMesh& surface);

/**
 * Adds the triangles of a clean C0, with points of their own, to those of M. They are marked in
 * `Multiplicities` and are 0 in `SignedMultiplicities`.
 */
void AddInitialSurface(const ResolvedMesh& initial, ResolvedMesh& surface);

/**
 * Removes the tetrahedra outside C0 and the triangles that belong to C0 alone. Returns an empty
 * string, or an error if a part of M lies outside C0.
 */
std::string RemoveOutsideOfInitial(Tetrahedralization& mesh);

} // namespace carving::helper

#endif
