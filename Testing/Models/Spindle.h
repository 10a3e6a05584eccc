// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A mesh over rows of points between two ends, for leaves and branches.
 */
#ifndef Spindle_h
#define Spindle_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace models
{

/**
 * Adds points and triangles: from the point `first` over rows of equal length to the point `last`.
 * If `closed`, rows are rings; rings that are counter-clockwise when seen from `last` bound a solid
 * oriented outward.
 */
void AddSpindle(carving::TriangleMesh& mesh, const carving::Point& first,
  const std::vector<std::vector<carving::Point>>& rows, const carving::Point& last, bool closed);

} // namespace models

#endif
