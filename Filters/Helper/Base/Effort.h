// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Effort_h
#define carving_Effort_h

#include <cstddef>

/** To a mesh of so many points no more than this are added: they would be of no use to anybody. */
inline std::size_t MaximumPointsAdded(std::size_t numberOfPoints)
{
  return 10 * numberOfPoints + 100000;
}

#endif
