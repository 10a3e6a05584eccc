// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Attempts.h"

#include "Core/Protocol/SecondsSince.h"
#include "Helper/Attempts/Patience.h"
#include "Helper/Attempts/Shuffle.h"
#include "Helper/Base/GrownBox.h"
#include "Helper/Exact/CrackEdges.h"
#include "Helper/Exact/InitialSurface.h"

#include <chrono>

namespace carving::helper
{

Attempts::Attempts(const Job& job, Reply& reply, const StrategyHost& host)
  : TheJob(job)
  , TheReply(reply)
  , Host(host)
  , IsCustom(job.Initial == InitialApproximation::Custom)
  , IsRecovery(job.Strategy == Strategy::Recover)
{
}

std::vector<Point> Attempts::FurtherPoints(const std::vector<Point>& points) const
{
  const bool isBox = this->TheJob.Initial == InitialApproximation::BoundingBox;
  return isBox && !points.empty() ? GrownBox(points) : std::vector<Point>();
}

bool Attempts::TryInChild(const std::string& attempt, const std::string& subject,
  const Limits& limits, const Task& task, const std::function<bool()>& meanwhile)
{
  const auto start = std::chrono::steady_clock::now();
  const Work work = { [&] { return this->Do(task); },
    [&](std::ostream& out) { WriteTask(out, task, this->TheJob, this->TheReply); } };
  const Ending ending = RunInChildProcess(limits, work, meanwhile);
  if (ending.Mistake == NotWanted)
  {
    return false;
  }
  this->HasFinished = ending.Mistake.empty() || ending.Mistake == WorkFailed;
  this->ProcessorSeconds = ending.ProcessorSeconds;
  if (!ending.Mistake.empty())
  {
    this->TheReply.StageSeconds[static_cast<int>(Stage::Attempts)] += SecondsSince(start);
  }
  if (!this->HasFinished)
  {
    this->Failures.Add(attempt, ending, subject);
  }
  return ending.Mistake.empty();
}

bool Attempts::TryOrder(const std::string& strategy, int order, SurfacePoints surfacePoints,
  const std::function<bool()>& meanwhile)
{
  this->TheReply.Strategy = strategy + (order == 0 ? "" : ", order " + std::to_string(order));
  const Limits limits =
    LimitsOfAttempt(this->TheJob, surfacePoints, this->TheReply.Result.Surface.Facets.size());
  return this->TryInChild(this->TheReply.Strategy + ": ", "TetGen ", limits,
    { Task::Goal::Ordered, order, surfacePoints }, meanwhile);
}

bool Attempts::TryOrders(
  const std::string& strategy, int first, int last, SurfacePoints surfacePoints)
{
  for (int order = first; order < last; ++order)
  {
    if (this->TryOrder(strategy, order, surfacePoints))
    {
      return true;
    }
  }
  return false;
}

bool Attempts::TryRecovery(RecoveryEffort effort, const std::function<bool()>& meanwhile)
{
  this->TheReply.Strategy = "Delaunay, recovery";
  const Limits limits =
    LimitsOfAttempt(this->TheJob, SurfacePoints::None, this->TheReply.Result.Surface.Facets.size());
  const auto goal =
    effort == RecoveryEffort::Little ? Task::Goal::QuicklyRecovered : Task::Goal::Recovered;
  return this->TryInChild(this->TheReply.Strategy + ": ", "recovery ", limits, { goal }, meanwhile);
}

bool Attempts::RunTetGen(int order, SurfacePoints surfacePoints)
{
  this->Host.Begin(Stage::Tetrahedralize);
  Tetrahedralization& result = this->TheReply.Result;
  Shuffle(order, result.Surface);
  Ending ending = Tetrahedralize(this->FurtherPoints(result.Surface.Points), surfacePoints, result);
  if (ending.Mistake.empty() && surfacePoints == SurfacePoints::Allowed &&
    this->TheJob.Conformity == Conformity::Auto && this->TheJob.Solid != SolidRule::SurfaceOnly &&
    HasCracksThatStayOpen(result))
  {
    ending.Mistake = "TetGen added points on the sides of cracks, which cannot be closed then";
  }
  return this->WriteExact(ending);
}

bool Attempts::RunRecovery(RecoveryEffort effort)
{
  this->Host.Begin(Stage::Tetrahedralize);
  Tetrahedralization& result = this->TheReply.Result;
  return this->WriteExact(RecoverAll(this->FurtherPoints(result.Surface.Points), effort,
    this->TheJob.Processes, this->Host.Report, result));
}

/** Writes the result of an attempt at the resolved mesh, or records why there is none. */
bool Attempts::WriteExact(const Ending& ending)
{
  Tetrahedralization& result = this->TheReply.Result;
  if (!ending.Mistake.empty())
  {
    this->Failures.Add(this->TheReply.Strategy + ": ", ending);
    return false;
  }
  if (this->IsCustom)
  {
    this->TheReply.Error = RemoveOutsideOfInitial(result);
    if (!this->TheReply.Error.empty())
    {
      this->Host.End();
      return this->WriteError();
    }
  }
  this->Failures.CopyTo(this->TheReply);
  return this->WriteResult();
}

bool Attempts::WriteResult()
{
  this->Host.End();
  const bool written = this->Host.Write();
  if (!written)
  {
    this->Failures.Add(this->TheReply.Strategy + ": ", { "the result could not be written" });
  }
  return written;
}

bool Attempts::WriteError()
{
  return this->Host.Write();
}

} // namespace carving::helper
