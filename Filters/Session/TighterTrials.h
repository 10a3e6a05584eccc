// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Steps of a stream that are decimated again, within a bound of the distance.
 */
#ifndef TighterTrials_h
#define TighterTrials_h

#include "Session/LevelTrials.h"

#include <vector>

/**
 * The bound within which a surface with so many vertices is decimated again if its result is at a
 * distance: a little less. Infinite for many vertices, which would take long.
 */
double FindTighterBound(int vertices, double error);

/**
 * The steps of the best trials for numbers, which are tried again: within bounds that are raised to
 * a little below the distances that have been reached. Not for steps with many vertices, which would
 * take long.
 *
 * At first, this is the best step for each number. Next, these are other good steps with few
 * vertices for the numbers that have gained: hardly any step gains where the best one has not.
 */
std::vector<LevelTrial> PlanTighterTrials(const carving::Profile& profile,
  const std::vector<carving::SimplifiedTarget>& targets, const std::vector<LevelTrial>& trials);

/**
 * Steps halfway between the best trial for each number and the next ones before and after, if a
 * bound has made that trial the best and the step has few vertices. Within a bound, a result may be
 * as close as its step is: finer steps are closer.
 */
std::vector<LevelTrial> PlanTighterTrialsBetween(const carving::Profile& profile,
  const std::vector<carving::SimplifiedTarget>& targets, const std::vector<LevelTrial>& trials);

#endif
