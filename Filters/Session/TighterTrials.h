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
 * Steps that are decimated for numbers, within bounds a little below the distances that have been
 * reached: those of the best trials, and the next coarser and finer ones that have been tried.
 * Within a bound, a result may be as close as its step is, and finer steps are closer, so that a
 * result without a bound tells little. Where there is nothing to gain from a neighbor, the step
 * halfway to it takes its place. Nothing is planned for a number for which the last trials have
 * gained nothing.
 */
std::vector<LevelTrial> PlanTighterTrials(const carving::Profile& profile,
  const std::vector<carving::SimplifiedTarget>& targets, const std::vector<LevelTrial>& trials);

#endif
