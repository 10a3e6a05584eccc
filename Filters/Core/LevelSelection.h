// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which steps of a stream become levels of detail.
 */
#ifndef carving_LevelSelection_h
#define carving_LevelSelection_h

#include "Profile.h"

#include <vector>

namespace carving
{

/**
 * At most `count` steps, ascending: the first is 0 and the last is the stream's last; between them
 * the vertex counts grow geometrically. Where too few distinct vertex counts exist the rest are
 * spread by steps, and where too few steps exist there are fewer levels.
 */
std::vector<int> SpreadLevels(const Profile& profile, int count);

/**
 * The last step such that it and all before it count at most `limit`. `counts` has an entry per
 * step. -1 where even C0 counts more.
 */
int LastStepWithin(const std::vector<int>& counts, double limit);

} // namespace carving

#endif
