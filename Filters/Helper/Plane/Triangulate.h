// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Triangulate_h
#define carving_Triangulate_h

#include "Core/Protocol/Protocol.h"
#include "Helper/Plane/ResolveContours.h"

#include <string>

/**
 * The triangles of C0, constrained by the edges of M: the convex hull of all points, a rectangle
 * around them, or the inside of the edges of C0 that InsertInitialContour inserted. Returns an
 * empty string or why there are none: no edge, no area, or an edge of `given` outside of C0.
 */
std::string Triangulate(const Contours& contours, carving::InitialApproximation initial,
  const carving::ContourSet& given, carving::Decomposition<2>& result);

#endif
