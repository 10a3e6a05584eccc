// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Winding numbers of regions.
 */
#ifndef carving_RegionWindings_h
#define carving_RegionWindings_h

#include "Core/Solid/Classification.h"

namespace carving
{

/** A winding number of at least this magnitude makes a region solid. */
constexpr double SolidFrom = 0.5;

/**
 * Finds the winding numbers of all enclosed regions, and whether they are guesses: see SolidRule.
 * The regions are of kind Outside, Kept, or Void for those that are enclosed.
 */
template <int D>
void FindWindings(const Decomposition<D>& mesh, int threads, Classification& result);

} // namespace carving

#endif
