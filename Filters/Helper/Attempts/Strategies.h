// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The strategies for tetrahedralizing M, tried one after the other until one succeeds.
 */
#ifndef carving_Strategies_h
#define carving_Strategies_h

#include "Core/Protocol/Protocol.h"

#include <functional>
#include <iosfwd>

namespace carving::helper
{

/** The services of the program that the strategies run in. */
struct StrategyHost
{
  std::function<void(Stage)> Begin;
  std::function<bool(double)> Report;
  std::function<void()> End;
  /** Writes the reply, from whichever process, over any reply that a failed attempt wrote. */
  std::function<bool()> Write;
};

/**
 * Resolves and tetrahedralizes `reply.Result.Surface`, which has been cleaned, and writes the
 * reply. Each strategy runs in a child process:
 * 1. TetGen on M as it is; before, if M is near Delaunay and does not cross itself, recovery with
 *    little effort, which takes half of the time. Since many failures depend on the order of the
 *    points and triangles alone, another order follows; so do recovery in a Delaunay
 *    tetrahedralization (first, if TetGen has crashed or taken too long), M without the triangles
 *    inside the solid, and M with points added on its triangles.
 * 2. If the job has a SnapTolerance and C0 is not given, recovery and TetGen on M with other
 *    triangles in flat parts; TetGen on M with the parts joined that touch but for rounding, and on
 *    M with its points rounded to a grid.
 * 3. The enclosing Delaunay tetrahedralization, which always succeeds, unless the job's conformity
 *    is Exact or C0 is given.
 *
 * The job's Strategy leaves out recovery, or TetGen: then recovery is the only exact attempt, at
 * the mesh as it is and at snapped ones.
 *
 * Where a processor is free, strategy 3 begins while the others take long
 * (PatienceBeforeEnclosing), and the reply is written once they have failed.
 *
 * A job whose conformity is Enclosing starts with strategy 3. With Auto, strategies 1 and 2 give up
 * where resolving so many crossings would multiply M.
 *
 * Returns false with `reply.Error`, which the caller writes, if all strategies fail.
 */
bool TryStrategies(const Job& job, Reply& reply, const StrategyHost& host);

/**
 * Does the part of TryStrategies that another process has handed to this one, and reads the job and
 * the reply so far before. Returns whether a reply has been written.
 */
bool ResumeStrategies(std::istream& in, Job& job, Reply& reply, const StrategyHost& host);

} // namespace carving::helper

#endif
