// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Triangulate_h
#define carving_Triangulate_h

#include "Core/Protocol/Protocol.h"
#include "Helper/Plane/ResolveContours.h"

#include <string>

namespace carving::helper
{

/**
 * The constrained Delaunay triangulation of C0: the convex hull of all points, a rectangle around
 * them, or the interior of the edges that InsertInitialContour has inserted. Returns an empty
 * string, or an error: there is no edge or no area, or an edge of `given` lies outside C0.
 */
std::string Triangulate(const Contours& contours, InitialApproximation initial,
  const ContourSet& given, Decomposition<2>& result);

} // namespace carving::helper

#endif
