// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which steps of a stream are decimated for which levels.
 *
 * A level with few vertices can be carved up to that number, or be carved further and decimated.
 * Collapses keep the topology of a step, and stick where tunnels and components need all remaining
 * vertices. A step of the same topology with fewer vertices only gives levels that are farther from
 * M. So trials decimate the last step, and earlier ones whose topology differs.
 */
#ifndef LevelTrials_h
#define LevelTrials_h

#include "Core/Measure/SimplifiedStream.h"
#include "Core/Protocol/Protocol.h"

#include <cmath>
#include <string>
#include <vector>

/** All targets of a trial have bounds, or none has; see carving::DecimationOptions. */
struct TrialTarget
{
  double Value;
  double Bound = HUGE_VAL;
};

/** A step of a stream that is decimated to some targets. */
struct LevelTrial
{
  int LastStep; ///< of the targets
  int Step;
  std::vector<TrialTarget> Targets; ///< from fine to coarse
  carving::Decimation Result;
  std::string Error;       ///< empty if the step could be decimated
  std::vector<int> Points; ///< of the step's surface, in the stream
  std::vector<int> Cells;  ///< per face of the step's surface: the cell of the stored stream
  int SurfaceComponents = 0;
  int SurfaceGenus = 0;
};

/**
 * The last step for each target, steps at halved numbers of vertices where the topology differs (if
 * there are none, at halved numbers of components and tunnels), C0, and the steps that reach
 * numbers without a collapse: no level is farther from M. Each is tried for all finer numbers, too.
 * The targets are of one type and sorted from coarse to fine.
 */
std::vector<LevelTrial> PlanTrials(
  const carving::Profile& profile, const std::vector<carving::SimplifiedTarget>& targets);

/**
 * Steps halfway between the best trial for each target and the next ones that have been tried
 * before and after, where the topology differs. They are tried for all coarser targets, and for all
 * finer numbers, too.
 */
std::vector<LevelTrial> PlanTrialsBetween(const carving::Profile& profile,
  const std::vector<carving::SimplifiedTarget>& targets, const std::vector<LevelTrial>& trials);

/**
 * The steps of the best trials for numbers, which are tried again: within bounds that are raised to
 * a little below the distances that have been reached. Not for steps with many vertices, which are
 * close to M and would take long.
 */
std::vector<LevelTrial> PlanTighterTrials(const carving::Profile& profile,
  const std::vector<carving::SimplifiedTarget>& targets, const std::vector<LevelTrial>& trials);

struct BestTrial
{
  const LevelTrial* Trial = nullptr; ///< null if no trial has a surface for the target
  const carving::DecimatedSurface* Surface = nullptr;
};

/**
 * The best trial of a step up to `lastStep` for a target, and its surface for this or a smaller
 * number: one that reaches the number, and has the smallest distance from M, or, within an error
 * bound, the fewest vertices.
 */
BestTrial FindBestTrial(
  const std::vector<LevelTrial>& trials, const carving::SimplifiedTarget& target, int lastStep);

#endif
