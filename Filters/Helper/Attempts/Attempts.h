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
#include "Helper/Attempts/Task.h"
#include "Helper/Recovery/RecoverAll.h"

namespace carving::helper
{

/** The base of the strategies. Functions named Try return whether a reply has been written. */
class Attempts
{
public:
  Attempts(const Job& job, Reply& reply, const StrategyHost& host);
  virtual ~Attempts() = default;

protected:
  /** Does a task, in the child process. Returns whether a reply has been written. */
  virtual bool Do(const Task& task) = 0;

  /** The points that C0 has besides those of M. */
  std::vector<Point> FurtherPoints(const std::vector<Point>& points) const;

  /**
   * Does a task in a child process, and records how the child ended unless the task has recorded
   * its own failure: `subject` and the mistake follow `attempt` on a line. `meanwhile` may find
   * that the work was for nothing (RunInChildProcess).
   */
  bool TryInChild(const std::string& attempt, const std::string& subject, const Limits& limits,
    const Task& task, const std::function<bool()>& meanwhile = {});

  /** Tries TetGen on the resolved mesh in one order; `meanwhile` as for TryInChild. */
  bool TryOrder(const std::string& strategy, int order, SurfacePoints surfacePoints,
    const std::function<bool()>& meanwhile = {});

  /** Tries the orders from `first` to the one before `last`. */
  bool TryOrders(const std::string& strategy, int first, int last, SurfacePoints surfacePoints);

  /** Tries recovery on the resolved mesh; `meanwhile` as for TryInChild. */
  bool TryRecovery(RecoveryEffort effort, const std::function<bool()>& meanwhile = {});

  // Do the same in this process:
  bool RunTetGen(int order, SurfacePoints surfacePoints);
  bool RunRecovery(RecoveryEffort effort);

  bool WriteResult();

  /** Writes an error that no other attempt could avoid: the given C0 is at fault. */
  bool WriteError();

  const Job& TheJob;
  Reply& TheReply;
  const StrategyHost& Host;
  bool IsCustom;   ///< C0 is given
  bool IsRecovery; ///< TetGen is not tried
  Log Failures;
  bool HasFinished = false;      ///< the last attempt: neither a crash nor a limit ended it
  double ProcessorSeconds = 0.0; ///< that the last attempt took

private:
  bool WriteExact(const Ending& ending);
};

} // namespace carving::helper

#endif
