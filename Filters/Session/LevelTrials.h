// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Steps of a stream that are decimated for simplified levels, and which of the results is best.
 */
#ifndef LevelTrials_h
#define LevelTrials_h

#include "Core/Measure/SimplifiedStream.h"
#include "Core/Protocol/Protocol.h"

#include <cmath>
#include <string>
#include <utility>
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
  std::vector<TrialTarget> Dropped; ///< targets for which the step is not worth its time
  carving::Decimation Result;
  std::string Error;       ///< empty if the step could be decimated
  std::vector<int> Points; ///< of the step's surface, in the stream
  std::vector<int> Cells;  ///< per face of the step's surface: the cell of the stored stream
  int SurfaceComponents = 0;
  int SurfaceGenus = 0;
  int VerticesThatTouch = 0;  ///< that share their points with others, and stay
  double LeastVertices = 0.0; ///< that the topology of the step's surface needs, in practice
};

/**
 * Adds a target to the trial of a step, which is added if there is none. No collapse may make a
 * face that is farther from M than `bound`.
 */
void AddTarget(std::vector<LevelTrial>& trials, const carving::SimplifiedTarget& target, int step,
  double bound = HUGE_VAL);

/** Drops targets of a trial before the trial runs. The predicate sees them in order. */
template <class Predicate>
void DropTargetsIf(LevelTrial& trial, Predicate&& predicate)
{
  std::vector<TrialTarget> kept;
  for (const TrialTarget& target : trial.Targets)
  {
    if (predicate(target))
    {
      trial.Dropped.push_back(target);
    }
    else
    {
      kept.push_back(target);
    }
  }
  trial.Targets = std::move(kept);
}

struct BestTrial
{
  const LevelTrial* Trial = nullptr; ///< null if no trial has a surface for the target
  const carving::DecimatedSurface* Surface = nullptr;
};

/** The number of vertices that a target asks for; 1 for an error bound. */
double CountVertices(const carving::SimplifiedTarget& target);

/** The number of vertices of a surface that a trial has made. */
int CountVertices(const LevelTrial& trial, const carving::DecimatedSurface& surface);

/** Whether a surface serves a target. One for another error bound may be within this one, too. */
bool HasReached(const carving::DecimatedSurface& surface, const carving::SimplifiedTarget& target);

/** Whether a trial without bounds has stuck above a number. */
bool HasStuck(const LevelTrial& trial, const carving::SimplifiedTarget& target);

/**
 * The trials with a surface for a target, best first, one surface per trial. A surface for a
 * smaller number counts if it is clearly closer to M; for an error bound, any surface counts.
 * Surfaces that reach a number come first, and among them the closest to M. Within an error bound,
 * the surface with the fewest vertices is best; beyond the bound, the closest.
 */
std::vector<BestTrial> RankTrials(
  const std::vector<LevelTrial>& trials, const carving::SimplifiedTarget& target);

/** The first of the ranked trials. */
BestTrial FindBestTrial(
  const std::vector<LevelTrial>& trials, const carving::SimplifiedTarget& target);

/**
 * The trials that levels are taken from, one per target. The targets are of one type and sorted
 * from coarse to fine. No level comes from a later step than a finer one, so that components only
 * split. That can rule out the best trials for some targets: the sum of the logarithms of the
 * distances is least, or of the numbers of vertices within error bounds.
 */
std::vector<BestTrial> ChooseTrials(
  const std::vector<LevelTrial>& trials, const std::vector<carving::SimplifiedTarget>& targets);

/**
 * Drops the numbers that the last step has reached well: there, only the details of M need more
 * vertices, and an earlier step would hardly be closer. Finer numbers are dropped, too. `diagonal`
 * is that of M. Numbers from `own` on, that of the earlier step itself, stay, since a trial
 * without collapses takes no time.
 */
void DropTargetsOfLastStep(
  const std::vector<LevelTrial>& trials, double diagonal, double own, LevelTrial& trial);

#endif
