// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * For how long a tetrahedralization is attempted. But for TimeLimit, in processor time: what comes out is not
 * to depend on what else the machine has to do.
 */
#ifndef carving_Patience_h
#define carving_Patience_h

#include "Core/Protocol/Protocol.h"
#include "Helper/Attempts/ChildProcess.h"
#include "Helper/Exact/Tetrahedralize.h"

/** For one attempt at a resolved mesh of so many triangles. */
Limits LimitsOfAttempt(
  const carving::Job& job, SurfacePoints surfacePoints, std::size_t numberOfFacets);

/** For resolving a mesh of so many triangles and all attempts at it together. */
Limits LimitsOfExact(const carving::Job& job, std::size_t numberOfFacets);

/** For enclosing a mesh: what the user has set. */
Limits LimitsOfEnclosing(const carving::Job& job);

#endif
