// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The selection of steps of a stream as levels of detail. Not in the paper.
 */
#ifndef carving_LevelSelection_h
#define carving_LevelSelection_h

#include "Core/Measure/Profile.h"

#include <array>
#include <string>
#include <vector>

namespace carving
{

/**
 * At most `count` steps, ascending, from 0 to the stream's last, with vertex counts that grow
 * geometrically. If there are too few distinct vertex counts, the rest are spread by steps; if
 * there are too few steps, all are given. A count of 1 gives the last step alone.
 */
std::vector<int> SpreadLevels(const Profile& profile, int count);

/** The quantity that a level target limits. */
enum class LevelTarget : int
{
  Vertices = 0,
  Triangles = 1,
  FeatureSize = 2,
  Tunnels = 3,
  Components = 4,
  ErrorBound = 5,
  Step = 6
};
constexpr int NumberOfLevelTargets = 7;

/** The name of the enumerator in the filters. */
const char* LevelTargetName(LevelTarget target);

struct SelectedStep
{
  int Step;
  std::string Problem; ///< empty if the target is met, else a sentence that says why not
};

/**
 * The step that a target selects. Vertices, Triangles, Tunnels, Components: the last step such that
 * it and all earlier ones have at most `target`. FeatureSize, a length: the step before the first
 * pop with a priority of at most `target`. ErrorBound: the first step such that neither it nor any
 * later one is farther than `target` from M. Step: `target` itself. If no step meets the target,
 * the nearest one is selected.
 */
SelectedStep SelectStep(const Profile& profile, LevelTarget type, double target);

/** The range of targets that select different levels. */
std::array<double, 2> GetTargetRange(const Profile& profile, LevelTarget type);

} // namespace carving

#endif
