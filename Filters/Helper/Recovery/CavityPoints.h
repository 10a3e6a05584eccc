// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_CavityPoints_h
#define carving_CavityPoints_h

#include "Helper/Recovery/Filling.h"

#include <random>

namespace carving::helper
{

/**
 * Adds up to `maximum` points off M to a cavity, which a filling may use. They are drawn in the
 * cells that have been removed, near their faces and near `triangle`; those are chosen that see
 * most faces of the front which no other point sees.
 */
void AddCavityPoints(const std::vector<Corners4>& cells, const Corners3& triangle, int maximum,
  std::mt19937& random, Cavity& cavity);

} // namespace carving::helper

#endif
