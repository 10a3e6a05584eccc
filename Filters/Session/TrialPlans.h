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
#ifndef TrialPlans_h
#define TrialPlans_h

#include "Session/LevelTrials.h"

#include <optional>
#include <vector>

/**
 * Whether earlier steps are tried before the last one, from coarse to fine: for a single error
 * bound. The coarsest step within the bound mostly has a result with fewer vertices than the
 * topology of most finer steps needs. With several bounds, the last step has to be tried for each
 * of them: levels take steps in order, and only the last step may follow any other.
 */
bool TriesCoarseStepsFirst(const std::vector<carving::SimplifiedTarget>& targets);

/** The last step for each target. */
std::vector<LevelTrial> PlanTrialsOfLastSteps(
  const std::vector<carving::SimplifiedTarget>& targets);

/**
 * Earlier steps: at halved numbers of vertices where the topology differs (if there are none, at
 * halved numbers of components and tunnels), C0, and the steps that reach numbers without a
 * collapse: no level is farther from M. Each is tried for all finer numbers, too. For an error
 * bound, the coarsest steps about within it take the place of C0. The targets are of one type and
 * sorted from coarse to fine. `known` are the trials up to now: where the last step has kept too
 * many vertices, the next of the earlier steps need not differ in topology.
 */
std::vector<LevelTrial> PlanTrials(const carving::Profile& profile,
  const std::vector<carving::SimplifiedTarget>& targets, const std::vector<LevelTrial>& known);

/** The steps next to another. Equal to that one where there is none. */
struct NeighborSteps
{
  int Coarser;
  int Finer;
};

/** The next steps that have been tried for a target. */
NeighborSteps FindNeighborSteps(
  const std::vector<LevelTrial>& trials, int of, const carving::SimplifiedTarget& target);

/** The step halfway between two others, by their numbers of vertices, if there is one. */
std::optional<int> FindStepBetween(const carving::Profile& profile, int coarser, int finer);

/**
 * Steps halfway between the best trial for each target and the next ones that have been tried
 * before and after, where the topology differs, if they have at most so many vertices. They are
 * tried for all coarser targets, and for all finer numbers, too.
 */
std::vector<LevelTrial> PlanTrialsBetween(const carving::Profile& profile,
  const std::vector<carving::SimplifiedTarget>& targets, const std::vector<LevelTrial>& trials,
  int mostVertices);

#endif
