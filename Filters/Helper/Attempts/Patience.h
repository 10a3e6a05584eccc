// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The limits of attempts. Time is processor time, so that the result does not depend on the load of
 * the machine, except where the user sets TimeLimit, which is by the clock.
 */
#ifndef carving_Patience_h
#define carving_Patience_h

#include "Core/Protocol/Protocol.h"
#include "Helper/Attempts/ChildProcess.h"
#include "Helper/Exact/Tetrahedralize.h"

namespace carving::helper
{

/** For one attempt at a resolved mesh of so many triangles. */
Limits LimitsOfAttempt(const Job& job, SurfacePoints surfacePoints, std::size_t numberOfFacets);

/** For resolving a mesh of so many triangles and all attempts at it together. */
Limits LimitsOfExact(const Job& job, std::size_t numberOfFacets);

/**
 * For all attempts at the mesh with its points moved, after exact attempts that took `used`
 * seconds: the rest of their time, and a quarter more. Where TetGen hung on the mesh, it mostly
 * hangs again; where TetGen soon crashed, most attempts succeed if they have the time.
 */
Limits LimitsOfSnapped(const Job& job, std::size_t numberOfFacets, double used);

/**
 * The seconds by the clock that exact attempts at a mesh of so many triangles may take before it is
 * enclosed beside them. Most successful attempts take less.
 */
double PatienceBeforeEnclosing(const Job& job, std::size_t numberOfFacets);

/** For enclosing a mesh: the user's limits alone. */
Limits LimitsOfEnclosing(const Job& job);

} // namespace carving::helper

#endif
