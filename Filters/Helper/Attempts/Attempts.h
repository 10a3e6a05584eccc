// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Attempts at a job, each in a child process.
 */
#ifndef carving_Attempts_h
#define carving_Attempts_h

#include "Helper/Attempts/ChildProcess.h"
#include "Helper/Attempts/Log.h"
#include "Helper/Attempts/Strategies.h"
#include "Helper/Exact/Tetrahedralize.h"

namespace carving::helper
{

/** The base of the strategies. Functions named Try return whether a reply has been written. */
class Attempts
{
public:
  Attempts(const Job& job, Reply& reply, const StrategyHost& host);

protected:
  /** The points that C0 has besides those of M. */
  std::vector<Point> FurtherPoints(const std::vector<Point>& points) const;

  /**
   * Does work in a child process, and records how the child ended unless the work has recorded its
   * own failure: `subject` and the mistake follow `attempt` on a line.
   */
  bool TryInChild(const std::string& attempt, const std::string& subject, const Limits& limits,
    const std::function<bool()>& work);

  /** Tries TetGen on the resolved mesh in the orders from `first` to the one before `last`. */
  bool TryOrders(const std::string& strategy, int first, int last, SurfacePoints surfacePoints);

  /** Tries recovery on the resolved mesh. */
  bool TryRecovery();

  bool WriteResult();

  /** Writes an error that no other attempt could avoid: the given C0 is at fault. */
  bool WriteError();

  const Job& TheJob;
  Reply& TheReply;
  const StrategyHost& Host;
  bool IsCustom;   ///< C0 is given
  bool IsRecovery; ///< TetGen is not tried
  Log Failures;

private:
  bool TryOrder(int order, SurfacePoints surfacePoints);
  bool WriteExact(const Ending& ending);
};

} // namespace carving::helper

#endif
