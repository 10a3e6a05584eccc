// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Patience.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

/**
 * Processor seconds that suffice for any mesh that TetGen can tetrahedralize, five times over.
 * TetGen takes 20 milliseconds per thousand triangles, four times as long if it puts points on
 * them, and on some meshes it never ends.
 */
double PatienceOfAttempt(const Job& job, SurfacePoints surfacePoints, std::size_t numberOfFacets)
{
  const double patience = surfacePoints == SurfacePoints::None
    ? 3.0 + 1e-4 * static_cast<double>(numberOfFacets)
    : 3.0 + 4e-4 * static_cast<double>(numberOfFacets);
  return job.Conformity == Conformity::Auto ? patience : 6.0 * patience;
}

} // namespace

Limits LimitsOfAttempt(const Job& job, SurfacePoints surfacePoints, std::size_t numberOfFacets)
{
  Limits limits = LimitsOfEnclosing(job);
  if (job.TimeLimit <= 0.0)
  {
    limits.ProcessorSeconds = PatienceOfAttempt(job, surfacePoints, numberOfFacets);
  }
  return limits;
}

Limits LimitsOfExact(const Job& job, std::size_t numberOfFacets)
{
  Limits limits;
  limits.Mebibytes = job.MemoryLimit;
  if (job.Conformity == Conformity::Auto)
  {
    limits.ProcessorSeconds =
      std::max(10.0 + 1e-4 * static_cast<double>(numberOfFacets), job.TimeLimit);
  }
  return limits;
}

Limits LimitsOfSnapped(const Job& job, std::size_t numberOfFacets, double used)
{
  Limits limits = LimitsOfExact(job, numberOfFacets);
  const double exact = limits.ProcessorSeconds;
  limits.ProcessorSeconds = 0.25 * exact + std::max(0.0, exact - used);
  return limits;
}

double PatienceBeforeEnclosing(const Job& job, std::size_t numberOfFacets)
{
  return 0.25 * LimitsOfExact(job, numberOfFacets).ProcessorSeconds;
}

Limits LimitsOfEnclosing(const Job& job)
{
  Limits limits;
  limits.Seconds = job.TimeLimit;
  limits.Mebibytes = job.MemoryLimit;
  return limits;
}

} // namespace carving::helper
