// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * A contour that the user gives for C0 (section 3.1).
 */
#ifndef carving_InitialContour_h
#define carving_InitialContour_h

#include "Core/Mesh/Mesh.h"
#include "Helper/Plane/ResolveContours.h"

#include <string>
#include <vector>

/**
 * Checks that edges are the boundary of one simple polygon and resolves them together with those of
 * M, which have been cleaned and resolved. Returns an empty string, or the first check that fails.
 */
std::string InsertInitialContour(const carving::ContourSet& initial, Contours& contours);

/**
 * Removes the triangles outside of C0 and the edges that are only C0's; `initial` marks per edge those
 * of C0. Returns an empty string or, if some of M, the edges `given`, lies outside, an error.
 */
std::string RemoveOutsideOfInitial(const carving::ContourSet& given,
  const std::vector<char>& initial, carving::Decomposition<2>& mesh);

#endif
