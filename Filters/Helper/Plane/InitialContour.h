// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * A C0 that the user gives as a contour (section 3.1).
 */
#ifndef carving_InitialContour_h
#define carving_InitialContour_h

#include "Core/Mesh/Mesh.h"
#include "Helper/Plane/ResolveContours.h"

#include <string>
#include <vector>

namespace carving::helper
{

/**
 * Checks that edges are the boundary of one simple polygon, and resolves them together with the
 * edges of M, which have been cleaned and resolved. Returns an empty string, or a message about the
 * first check that fails.
 */
std::string InsertInitialContour(const ContourSet& initial, Contours& contours);

/**
 * Removes the triangles outside C0 and the edges that belong to C0 alone, which come last.
 * `initial` marks the edges of C0. Returns an empty string, or an error if a part of M, the edges
 * `given`, lies outside C0.
 */
std::string RemoveOutsideOfInitial(
  const ContourSet& given, const std::vector<char>& initial, Decomposition<2>& mesh);

} // namespace carving::helper

#endif
