// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Decimates a surface to several targets, from the finest to the coarsest.
 */
#ifndef carving_TargetSeries_h
#define carving_TargetSeries_h

#include "Core/Mesh/FaceDistance.h"
#include "Core/Mesh/Progress.h"
#include "Core/Protocol/Protocol.h"
#include "Helper/Decimation/Decimator.h"

#include <string>
#include <vector>

namespace carving::helper
{

/**
 * Decimates the surface of `decimator` once per target of the options, each time going on from the
 * last result, and appends the results. Distances are those from M. Returns an empty string, or an
 * error.
 */
std::string DecimateToTargets(Decimator& decimator, const FaceDistance<3>& fromM,
  const DecimationOptions& options, const Progress& progress, int threads,
  std::vector<DecimatedSurface>& results);

} // namespace carving::helper

#endif
