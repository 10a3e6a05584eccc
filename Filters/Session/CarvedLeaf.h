// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a decomposition to a stream and its profile.
 */
#ifndef CarvedLeaf_h
#define CarvedLeaf_h

#include "Core/Measure/Profile.h"
#include "Core/Measure/SimplifiedStream.h"
#include "Core/Stream/StoredStream.h"
#include "Session/CarverSettings.h"
#include "Session/DecomposedLeaf.h"

/** A leaf of the input, carved. */
template <int D>
struct CarvedLeaf
{
  carving::StoredStream<D> Stream;
  carving::Profile Profile;
  carving::SimplifiedStream Simplified; ///< empty unless levels are simplified
  int GuessedRegions = 0; ///< regions of which the rule has guessed whether they are solid
  int LeftByBudget = 0;   ///< cells that would be carved without a budget
};

/**
 * Classifies the regions, carves, and measures the steps. Moves the decomposition if it is without
 * the solid: then no other update can use it. Returns false if the filter is to stop.
 */
template <int D>
bool CarveLeaf(DecomposedLeaf<D>& leaf, const CarverSettings& settings, CarverStages& stages,
  CarvedLeaf<D>& carved);

#endif
