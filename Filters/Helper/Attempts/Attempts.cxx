// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Attempts.h"

#include "Core/Protocol/SecondsSince.h"
#include "Helper/Attempts/Patience.h"
#include "Helper/Attempts/Shuffle.h"
#include "Helper/Base/GrownBox.h"
#include "Helper/Exact/InitialSurface.h"
#include "Helper/Recovery/RecoverAll.h"

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
  this->HasFinished = ending.Mistake.empty() || ending.Mistake == "failed";
  if (!ending.Mistake.empty())
  {
    this->TheReply.StageSeconds[static_cast<int>(Stage::Attempts)] += SecondsSince(start);
  }
  if (!this->HasFinished)
  {
    this->Failures.Add(attempt, { subject + ending.Mistake, ending.ByLimit });
  }
  return ending.Mistake.empty();
}

bool Attempts::TryOrders(
  const std::string& strategy, int first, int last, SurfacePoints surfacePoints)
{
  const Limits limits =
    LimitsOfAttempt(this->TheJob, surfacePoints, this->TheReply.Result.Surface.Facets.size());
  for (int order = first; order < last; ++order)
  {
    this->TheReply.Strategy = strategy + (order == 0 ? "" : ", order " + std::to_string(order));
    if (this->TryInChild(this->TheReply.Strategy + ": ", "TetGen ", limits,
          { Task::Goal::Ordered, order, surfacePoints }))
    {
      return true;
    }
  }
  return false;
}

bool Attempts::TryUnresolved(const std::string& strategy, const std::function<bool()>& isResolved)
{
  this->TheReply.Strategy = strategy;
  bool resolved = false;
  const Limits limits =
    LimitsOfAttempt(this->TheJob, SurfacePoints::None, this->TheReply.Result.Surface.Facets.size());
  const bool written = this->TryInChild(strategy + ": ", "TetGen ", limits,
    { Task::Goal::Ordered, 0, SurfacePoints::None }, [&] { return resolved = isResolved(); });
  if (!resolved)
  {
    this->TheReply.Strategy.clear();
    this->Failures.Clear();
  }
  return written;
}

bool Attempts::TryOrder(int order, SurfacePoints surfacePoints)
{
  this->Host.Begin(Stage::Tetrahedralize);
  Tetrahedralization& result = this->TheReply.Result;
  Shuffle(order, result.Surface);
  return this->WriteExact(
    Tetrahedralize(this->FurtherPoints(result.Surface.Points), surfacePoints, result));
}

bool Attempts::TryRecovery()
{
  const Limits limits =
    LimitsOfAttempt(this->TheJob, SurfacePoints::None, this->TheReply.Result.Surface.Facets.size());
  this->TheReply.Strategy = "Delaunay, recovery";
  return this->TryInChild(
    this->TheReply.Strategy + ": ", "", limits, { Task::Goal::Recovered, 0, SurfacePoints::None });
}

bool Attempts::Recover()
{
  Tetrahedralization& result = this->TheReply.Result;
  this->Host.Begin(Stage::Tetrahedralize);
  return this->WriteExact(
    RecoverAll(this->FurtherPoints(result.Surface.Points), this->Host.Report, result));
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
