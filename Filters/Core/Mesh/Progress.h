// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How a long computation reports to its caller and learns that it should stop.
 */
#ifndef carving_Progress_h
#define carving_Progress_h

#include <functional>

namespace carving
{

/** Called with the fraction done, 0 to 1; returns false to stop. May be empty. */
using Progress = std::function<bool(double)>;

inline bool GoOn(const Progress& progress, double fraction)
{
  return !progress || progress(fraction);
}

} // namespace carving

#endif
