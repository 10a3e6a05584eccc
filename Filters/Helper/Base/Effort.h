// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Effort_h
#define carving_Effort_h

#include <cstddef>

namespace carving::helper
{

/**
 * The most points that may be added to a mesh of so many points. A result with more is of no use.
 */
inline std::size_t MaximumPointsAdded(std::size_t numberOfPoints)
{
  return 10 * numberOfPoints + 100000;
}

} // namespace carving::helper

#endif
