// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_GrownBox_h
#define carving_GrownBox_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/**
 * The distance between M and each side of InitialApproximation::BoundingBox, as a share of M's
 * diagonal.
 */
constexpr double BoxMargin = 0.01;

/** The corners of the points' bounding box, grown by BoxMargin of its diagonal on every side. */
std::vector<Point> GrownBox(const std::vector<Point>& points);

} // namespace carving::helper

#endif
