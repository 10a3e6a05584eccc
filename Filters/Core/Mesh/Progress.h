// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Progress reports of long computations, and requests to stop.
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

/**
 * The progress of a part of a computation. The part lasts from the fraction `begin` to `end` of the
 * whole. The result refers to `progress`, which has to outlive it.
 */
inline Progress PartOf(const Progress& progress, double begin, double end)
{
  return [&progress, begin, end](double fraction)
  { return GoOn(progress, begin + (end - begin) * fraction); };
}

} // namespace carving

#endif
