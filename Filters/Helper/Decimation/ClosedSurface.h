// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The check that triangles form a closed surface without self-intersections.
 */
#ifndef carving_ClosedSurface_h
#define carving_ClosedSurface_h

#include "Core/Mesh/Mesh.h"

#include <string>

namespace carving::helper
{

/**
 * Gives each fan of triangles a vertex of its own, so that vertices of several fans become copies,
 * and orients the surface outward as a whole. Returns an error for the user if the triangles do not
 * form a closed, consistently oriented surface, or cross each other. The error says in how many
 * places, and where the first one is.
 */
std::string MakeClosedSurface(ResolvedMesh& surface);

/**
 * Turns the parts of a closed surface that are inside out, if others are not: the winding number in
 * front of them is negative.
 */
void TurnPartsOutward(ResolvedMesh& surface);

} // namespace carving::helper

#endif
