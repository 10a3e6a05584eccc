// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers of components, tunnels and voids.
 */
#ifndef carving_BettiNumbers_h
#define carving_BettiNumbers_h

#include <array>

namespace carving
{

/** Components, tunnels and voids of a closed complex. */
using BettiNumbers = std::array<int, 3>;

/** Whether a budget limits anything; a negative number is no limit. */
inline bool HasLimits(const BettiNumbers& budget)
{
  return budget[0] >= 0 || budget[1] >= 0 || budget[2] >= 0;
}

} // namespace carving

#endif
