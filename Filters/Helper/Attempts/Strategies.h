// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The attempts at a tetrahedralization, one after the other, until one succeeds.
 */
#ifndef carving_Strategies_h
#define carving_Strategies_h

#include "Core/Protocol/Protocol.h"

#include <functional>

/** What the ladder asks of the program around it. */
struct StrategyHost
{
  std::function<void(carving::Stage)> Begin;
  std::function<bool(double)> Report;
  std::function<void()> End;
  /** Hands a reply over, from whichever process; what failed attempts have written is dropped. */
  std::function<bool()> Write;
};

/**
 * Resolves and tetrahedralizes `reply.Result.Surface`, which has been cleaned, and writes the reply. By
 * rungs, each in a process of its own:
 * 1. TetGen with M as it is, if need be with its points and triangles in other orders, which is all that
 *    many failures take, without the triangles inside the solid, and with points put on its triangles;
 * 2. where the job has a SnapTolerance and C0 is not given, TetGen with M's points rounded to a grid;
 * 3. unless the job's conformity is Exact, the Delaunay tetrahedralization that cannot fail.
 * Enclosing starts with 3; so does Auto where crossings are so many that resolving would multiply M.
 * Returns false with `reply.Error` if all rungs have failed; the caller writes that.
 */
bool TryStrategies(const carving::Job& job, carving::Reply& reply, const StrategyHost& host);

#endif
