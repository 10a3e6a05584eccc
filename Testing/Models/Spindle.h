// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What leaves and branches have in common: rows of points between two ends.
 */
#ifndef Spindle_h
#define Spindle_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace models
{

/**
 * Adds a mesh of its own points: from the point `first` over rows of equally many points to the point
 * `last`. If `closed`, rows are rings, and counter-clockwise seen from `last` they make a solid oriented
 * outward.
 */
void AddSpindle(carving::TriangleMesh& mesh, const carving::Point& first,
  const std::vector<std::vector<carving::Point>>& rows, const carving::Point& last, bool closed);

} // namespace models

#endif
