// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Levels by the pair: carved first, then decimated by edge collapses. Not in the paper, which names
 * both together as future work (section 7).
 */
#ifndef SimplifyLevels_h
#define SimplifyLevels_h

#include "Session/CarvedLeaf.h"

#include <string>
#include <vector>

/** The targets of simplified levels, from coarse to fine. */
std::vector<carving::SimplifiedTarget> MakeSimplifiedTargets(
  const carving::Profile& profile, const CarverSettings& settings);

/**
 * Makes the simplified stream: levels with a given number of vertices or triangles, or within an
 * error, as close to M as trials find them. There is a level for each target that no step of the
 * carving meets as it is, together with the decimated step that it comes from. From coarse to fine,
 * the steps never get earlier. A target that no trial meets gets the closest level, or none.
 * `problems` gets a sentence for each trial that fails. Returns false if the filter is to stop.
 */
bool SimplifyLevels(const DecomposedLeaf<3>& leaf, const CarverSettings& settings,
  CarverStages& stages, CarvedLeaf<3>& carved, std::vector<std::string>& problems);

#endif
