// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A decimation in the helper program whose surfaces are brought closer by a second one.
 */
#ifndef RepeatedDecimation_h
#define RepeatedDecimation_h

#include "Process/HelperProcess.h"

#include <cstddef>
#include <string>
#include <vector>

/**
 * Decimates a closed surface to numbers of vertices or triangles, and then again within bounds a
 * little below the distances of the first results, as trials for simplified levels are.
 */
class RepeatedDecimation
{
public:
  /** A surface, and the decimation that made it. */
  struct Found
  {
    const carving::Decimation& Origin;
    const carving::DecimatedSurface& Surface;
  };

  /** Runs a job of the kind Decimate. An error bound, and many vertices, take one run. */
  HelperProcess::Outcome Run(
    const carving::Job& job, const HelperProcess::Observer& observer, std::string& error);

  /** The closest surface for a target of the job, which has succeeded. */
  Found GetClosest(std::size_t target) const;

private:
  HelperProcess::Outcome RunOnce(const carving::Job& job, double begin, double end,
    const HelperProcess::Observer& observer, std::string& error);

  std::vector<carving::Decimation> Results; ///< of one run or two
};

#endif
