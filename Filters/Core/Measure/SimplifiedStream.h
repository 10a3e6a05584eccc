// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Simplified levels of a stream, and their selection. Not in the paper, which names carving and
 * decimation together as future work (section 7).
 */
#ifndef carving_SimplifiedStream_h
#define carving_SimplifiedStream_h

#include "Core/Measure/LevelSelection.h"
#include "Core/Stream/CollapseChain.h"

#include <limits>
#include <string>
#include <vector>

namespace carving
{

/** What a simplified level has to be: from a step up to the last, and within a target. */
struct SimplifiedTarget
{
  LevelTarget Type = LevelTarget::Vertices; ///< or Triangles or ErrorBound
  int LastStep = 0;
  double Value = 0.0;
  std::string Problem; ///< empty, or why `LastStep` is not what the user has asked for
};

/**
 * The target of a simplified level. Numbers of vertices and triangles and error bounds may use all
 * steps. Every other target selects the last step, and `maximumVertices` is the target unless 0.
 */
SimplifiedTarget MakeSimplifiedTarget(
  const Profile& profile, LevelTarget type, double target, int maximumVertices);

/** Whether the last step has no more vertices or triangles than the target as it is. */
bool IsMetByCarving(const Profile& profile, const SimplifiedTarget& target);

/** A step whose surface, cut into manifolds, has been decimated. */
struct DecimatedStep
{
  int Step = 0;
  CollapseChain Chain;     ///< the source of a face: the cell of the stored stream with its data
  std::vector<int> Points; ///< per point of the chain: the point of the stream
  int SurfaceComponents = 0;
  int SurfaceGenus = 0;
};

/** The result for a target. */
struct SimplifiedLevel
{
  int Chain = -1; ///< index of the decimated step; -1: none
  int Collapses = 0;
  double Error = std::numeric_limits<double>::quiet_NaN(); ///< from M; NaN if not measured
  int LastStep = 0;
  double Target = 0.0;
};

/** The decimated steps of a stream, with the levels for which they have been chosen. */
struct SimplifiedStream
{
  LevelTarget Type = LevelTarget::Vertices; ///< of the levels' targets
  std::vector<DecimatedStep> Steps;
  std::vector<SimplifiedLevel> Levels; ///< from coarse to fine
};

/**
 * The least number of vertices or triangles to which a step is decimated, or the least measured
 * error of a level; infinite for another type or if there is none.
 */
double FindLeastTarget(const SimplifiedStream& stream, LevelTarget type);

struct SelectedLevel
{
  SimplifiedLevel Level;
  std::string Problem; ///< empty, or a sentence that says why the target is not met
};

/**
 * The simplified level for a target, which need not be one of the targets that levels were made
 * for. A number gets the level of the decimated step that was best for the next larger target, or
 * of one for a smaller target where that step cannot be decimated to the number; if none can, of
 * the one with the fewest vertices. A number beyond all targets may get a later step. A lower
 * number thus never gets a later step than a higher one. An error bound gets the coarsest level
 * that was made within the bound.
 */
SelectedLevel SelectSimplifiedLevel(const SimplifiedStream& stream, const SimplifiedTarget& target);

/**
 * For an error bound that no simplified level meets: the first carved step within the bound that is
 * no earlier than any simplified level's, so that a smaller bound never gets an earlier step. -1 if
 * there is none, for another type, without simplified levels, or without errors in the profile.
 */
int FindCarvedStepWithin(
  const SimplifiedStream& stream, const Profile& profile, const SimplifiedTarget& target);

} // namespace carving

#endif
