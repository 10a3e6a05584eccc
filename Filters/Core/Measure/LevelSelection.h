// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which steps of a stream become levels of detail.
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
 * At most `count` steps, ascending: the first is 0 and the last is the stream's last; between them
 * the vertex counts grow geometrically. Where too few distinct vertex counts exist the rest are
 * spread by steps, and where too few steps exist there are fewer levels.
 */
std::vector<int> SpreadLevels(const Profile& profile, int count);

/** What a level target counts or measures. */
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

/** The name of the filters' enumerator. */
const char* LevelTargetName(LevelTarget target);

struct SelectedStep
{
  int Step;
  std::string Problem; ///< empty if the target is met, else a sentence that says why it is not
};

/**
 * The last step such that it and all before it have at most `target` vertices, triangles, tunnels or
 * components; the one before the first pop with a priority of at most `target`, a length; the first such
 * that neither it nor any after it is farther than `target` from M; or step `target`. What cannot be met
 * gives the nearest step.
 */
SelectedStep SelectStep(const Profile& profile, LevelTarget type, double target);

/** The least and the greatest target that pick different levels. */
std::array<double, 2> GetTargetRange(const Profile& profile, LevelTarget type);

} // namespace carving

#endif
