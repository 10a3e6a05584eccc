// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Strategies.h"

#include "Core/Protocol/SecondsSince.h"
#include "Helper/Attempts/Demand.h"
#include "Helper/Attempts/ExactAttempts.h"
#include "Helper/Attempts/Patience.h"
#include "Helper/Exact/Tetrahedralize.h"
#include "Helper/Recovery/Enclose.h"

#include <chrono>
#include <cmath>
#include <sstream>
#include <string>

namespace carving::helper
{
namespace
{

/** The lines, which may end in full stops, as one sentence. */
std::string Joined(const std::string& lines)
{
  std::istringstream in(lines);
  std::string joined, line;
  while (std::getline(in, line))
  {
    line.erase(line.find_last_not_of('.') + 1);
    joined += (joined.empty() ? "" : "; ") + line;
  }
  return joined + ".";
}

/** One run of TryStrategies. Functions named Try return whether a reply has been written. */
class StrategyRun : private ExactAttempts
{
public:
  using ExactAttempts::ExactAttempts;
  bool TryAll();
  bool Do(const Task& task) override;

private:
  bool TryAllExact();
  bool TryUntilEnclosed();
  bool MayEncloseInAdvance() const;
  bool TryEnclosing();

  Demand Enclosing; ///< for the enclosing tetrahedralization
};

bool StrategyRun::TryAll()
{
  const ResolvedMesh& surface = this->TheReply.Result.Surface;
  if (!this->IsCustom)
  {
    this->TheReply.Error = CheckVolume(surface, this->FurtherPoints(surface.Points));
    if (!this->TheReply.Error.empty())
    {
      return false;
    }
  }
  const bool mayEnclose = this->TheJob.Conformity != Conformity::Exact && !this->IsCustom;
  if (mayEnclose ? this->TryUntilEnclosed() : this->TryAllExact())
  {
    return true;
  }
  this->Failures.CopyTo(this->TheReply);
  this->TheReply.Error = mayEnclose
    ? "The mesh could not even be enclosed. Raise TimeLimit or MemoryLimit if they are set. "
      "Attempts: "
    : std::string(this->IsRecovery ? "Recovery" : "TetGen") +
      " cannot tetrahedralize the mesh. Repair or remove the parts that cross themselves or nearly "
      "touch, set Conformity to AUTO, set SnapTolerance, or raise TimeLimit or MemoryLimit if they "
      "are set. Attempts: ";
  this->TheReply.Error += Joined(this->TheReply.Attempts);
  return false;
}

/** Tries M as it is, and with its points moved, unless M is only to be enclosed. */
bool StrategyRun::TryAllExact()
{
  if (this->TheJob.Conformity == Conformity::Enclosing)
  {
    return false;
  }
  const std::size_t facets = this->TheReply.Result.Surface.Facets.size();
  if (this->TryInChild("", "Resolving and tetrahedralizing ", LimitsOfExact(this->TheJob, facets),
        { Task::Goal::Exact }) ||
    (this->TheJob.SnapTolerance > 0.0 && !this->IsCustom &&
      this->TryInChild("", "Snapping ",
        LimitsOfSnapped(this->TheJob, facets, this->ProcessorSeconds), { Task::Goal::Snapped })))
  {
    return true;
  }
  this->TheReply.SolidMatters = 1; // an attempt without the interior may have succeeded
  return false;
}

/** Encloses M where it may not or cannot be met exactly. */
bool StrategyRun::TryUntilEnclosed()
{
  bool isExact = false;
  const auto isEnclosingWanted = [&]
  {
    isExact = this->TryAllExact();
    if (!isExact)
    {
      this->Enclosing.Raise();
    }
    return !isExact;
  };
  std::function<bool()> meanwhile;
  if (this->MayEncloseInAdvance())
  {
    meanwhile = isEnclosingWanted;
  }
  else if (!isEnclosingWanted())
  {
    return true;
  }
  const auto enclose = [this](const std::function<bool()>& beside)
  {
    return this->TryInChild("Delaunay, enclosing: ", "", LimitsOfEnclosing(this->TheJob),
      { Task::Goal::Enclosing }, beside);
  };
  if (enclose(meanwhile) || isExact)
  {
    return true;
  }
  // Beside the exact attempts, the memory of the machine may not have been enough.
  return meanwhile && this->TheJob.MemoryLimit <= 0.0 && enclose({});
}

/** Whether the mesh may be enclosed on another processor while the exact attempts take long. */
bool StrategyRun::MayEncloseInAdvance() const
{
  constexpr std::size_t mostFacets = 1000000; // both processes need some kilobytes for each
  return this->TheJob.Conformity == Conformity::Auto && this->TheJob.Processes > 1 &&
    this->TheJob.TimeLimit <= 0.0 && ChildProcessesEndWithThis() &&
    this->TheReply.Result.Surface.Facets.size() <= mostFacets;
}

bool StrategyRun::Do(const Task& task)
{
  switch (task.What)
  {
    case Task::Goal::Exact:
      return this->TryExact();
    case Task::Goal::Snapped:
      return this->TrySnapped();
    case Task::Goal::Enclosing:
      return this->TryEnclosing();
    case Task::Goal::QuicklyRecovered:
      return this->RunRecovery(RecoveryEffort::Little);
    case Task::Goal::Recovered:
      return this->RunRecovery(RecoveryEffort::Much);
    case Task::Goal::Ordered:
      return this->RunTetGen(task.Order, task.Points);
  }
  return false;
}

bool StrategyRun::TryEnclosing()
{
  const auto start = std::chrono::steady_clock::now();
  const ResolvedMesh input = std::move(this->TheReply.Result.Surface);
  const std::vector<Point> further = this->FurtherPoints(input.Points);
  this->Enclosing.Await(PatienceBeforeEnclosing(this->TheJob, input.Facets.size()));
  bool hasBegun = false;
  // Until the result is wanted, progress and time are those of the exact attempts.
  const auto report = [&](double fraction)
  {
    if (!hasBegun && this->Enclosing.IsRaised())
    {
      hasBegun = true;
      this->TheReply.StageSeconds[static_cast<int>(Stage::Attempts)] += SecondsSince(start);
      this->TheReply.Strategy = "Delaunay, enclosing";
      this->Host.Begin(Stage::Tetrahedralize);
    }
    return !hasBegun || this->Host.Report(fraction);
  };
  report(0.0);
  const Enclosure enclosure =
    Enclose(input, further, { this->TheJob.EnclosingTolerance, this->TheJob.SnapTolerance },
      this->TheJob.Processes, report, this->TheReply.Result);
  this->Enclosing.Await(HUGE_VAL);
  report(1.0);
  this->TheReply.SolidMatters = this->TheJob.Conformity != Conformity::Enclosing;
  this->Failures.CopyTo(this->TheReply);
  this->TheReply.SnapDistance = enclosure.FlatDistance;
  this->TheReply.KeptDistance = enclosure.Distances.Maximum;
  this->TheReply.KeptDistance99 = enclosure.Distances.Percentile99;
  this->TheReply.KeptDistanceMean = enclosure.Distances.Mean;
  this->TheReply.MetShare = enclosure.MetShare;
  this->TheReply.IntersectingPairs = enclosure.ResolvedPairs;
  const Tetrahedralization& result = this->TheReply.Result;
  this->TheReply.PointsAdded = static_cast<int>(
    result.Surface.Points.size() - result.Unresolved.Points.size() - further.size());
  return this->WriteResult();
}

} // namespace

bool TryStrategies(const Job& job, Reply& reply, const StrategyHost& host)
{
  return StrategyRun(job, reply, host).TryAll();
}

bool ResumeStrategies(std::istream& in, Job& job, Reply& reply, const StrategyHost& host)
{
  Task task;
  ReadTask(in, task, job, reply);
  return StrategyRun(job, reply, host).Do(task);
}

} // namespace carving::helper
