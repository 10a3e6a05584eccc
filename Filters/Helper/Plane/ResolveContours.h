// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Cleaning and resolving in the plane.
 */
#ifndef carving_ResolveContours_h
#define carving_ResolveContours_h

#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Progress.h"

#include <string>
#include <vector>

namespace carving::helper
{

/**
 * Edges in the plane of the first two coordinates. Points with the same first two coordinates are
 * equal. `Initial` has one entry per edge: whether the boundary of C0 runs along it. An edge of C0
 * that is no edge of M has the multiplicity 0.
 */
struct Contours : ResolvedInput<2>
{
  std::vector<char> Initial;
};

/** The given edges of M, or, with `initial`, of the boundary of C0, whose points have no source. */
Contours AsContours(const ContourSet& given, bool initial);

/** Appends the edges of another set. */
void Append(const Contours& other, Contours& contours);

/**
 * Merges equal points into the first of them, merges equal edges into the first of them, and drops
 * edges without length and points that no edge uses. Points and edges keep their order.
 */
Contours Clean(const Contours& contours);

/**
 * Splits edges where they intersect until any two meet only in common ends. Points of intersection
 * are exact, then rounded to doubles. Since rounding can create new intersections, rounds of
 * splitting follow until none is left.
 *
 * `contours` has been cleaned and stays clean. `splitPoints` is set to the number of points in the
 * interior of given edges at which other edges meet them. Returns an empty string, or why
 * intersections are left.
 */
std::string Resolve(Contours& contours, int& splitPoints, const Progress& progress);

} // namespace carving::helper

#endif
