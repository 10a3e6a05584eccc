// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * carving-helper: reads a job and writes the reply to the files of HostLink.h, in the format of
 * Protocol.h. The exit code is 0 if there is a reply, even one with an error, and 2 if there is
 * none.
 */
#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/LargePages.h"
#include "Core/Protocol/Protocol.h"
#include "Core/Protocol/SecondsSince.h"
#include "Core/Solid/Cracks.h"
#include "Core/Solid/DropSolid.h"
#include "Core/Solid/Winding.h"
#include "Helper/Attempts/ChildProcess.h"
#include "Helper/Attempts/Strategies.h"
#include "Helper/Decimation/EnclosingDecimation.h"
#include "Helper/Exact/CrackEdges.h"
#include "Helper/HostLink.h"
#include "Helper/MemoryPages.h"
#include "Helper/Plane/InitialContour.h"
#include "Helper/Plane/Triangulate.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Intersections.h"
#include "Helper/Resolve/Orient.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <new>
#include <utility>

using namespace carving;
using namespace carving::helper;

namespace
{

/** Reports progress on standard error and measures the time of each stage. */
class Reporter
{
public:
  explicit Reporter(Reply& reply)
    : Out(reply)
  {
    this->Out.StageSeconds.assign(NumberOfStages, 0.0);
  }

  void Begin(Stage stage)
  {
    this->Current = stage;
    this->Start = Clock::now();
    this->LastReported = -1.0;
    this->Report(0.0);
  }

  /** Writes at most a hundred lines per stage. */
  bool Report(double fraction)
  {
    if (fraction >= this->LastReported + 0.01)
    {
      this->LastReported = fraction;
      std::fputs(ProgressLine({ this->Current, fraction, this->Out.Strategy }).c_str(), stderr);
    }
    return true;
  }

  void End()
  {
    this->Out.StageSeconds[static_cast<int>(this->Current)] += SecondsSince(this->Start);
  }

private:
  using Clock = std::chrono::steady_clock;
  Reply& Out;
  Stage Current = Stage::Clean;
  Clock::time_point Start;
  double LastReported = -1.0;
};

void CleanGiven(const Job& job, Reply& reply, Reporter& reporter)
{
  reporter.Begin(Stage::Clean);
  reply.Result.Surface = Clean(AsResolved(job.Mesh));
  OrientAlike(reply.Result.Surface);
  reporter.End();
}

void CountIntersections(const Job& job, Reply& reply)
{
  Reporter reporter(reply);
  CleanGiven(job, reply, reporter);
  const ResolvedMesh mesh = std::move(reply.Result.Surface);
  reply.Result = {};
  reporter.Begin(Stage::Resolve);
  reply.IntersectingPairs = static_cast<int>(FindIntersections(mesh.Points, mesh.Facets).size());
  reporter.End();
}

/** Adds points that help to close cracks of M by the rule. */
void PrepareCracksOf(const Job& job, Reply& reply, Reporter& reporter)
{
  Tetrahedralization& result = reply.Result;
  if (!reply.Error.empty() || IsClosed(result.GetInput()))
  {
    return;
  }
  reporter.Begin(Stage::Classify);
  Tetrahedralization split;
  const CrackSplits splits =
    SplitEdgesThroughCracks(result, MostCrackWidth * Diagonal(result.GetInput()), split);
  if (splits.Points > 0)
  {
    const auto closesCracks = [&](SolidRule rule)
    {
      Tetrahedralization sealed = split;
      return SealCracks(sealed, rule, job.Processes) > 0;
    };
    const bool isOfUse = closesCracks(job.Solid);
    for (const SolidRule rule : { SolidRule::NonzeroWinding, SolidRule::EvenOdd })
    {
      // Another rule may close other cracks, or none.
      const bool matters = isOfUse || (rule != job.Solid && closesCracks(rule));
      reply.SolidMatters = reply.SolidMatters != 0 || matters;
    }
    reply.CracksOpen = !splits.AreEnough && !isOfUse && job.Solid != SolidRule::SurfaceOnly;
    if (isOfUse)
    {
      result = std::move(split);
    }
  }
  reporter.End();
}

/** Drops the solid from a result if the job asks for that. An enclosing result stays whole. */
void DropSolidOf(const Job& job, Reply& reply, Reporter& reporter)
{
  if (job.DropSolid != 0 && reply.Error.empty() && reply.Result.Kept.empty())
  {
    reporter.Begin(Stage::Classify);
    reply.CracksSealed = SealCracks(reply.Result, job.Solid, job.Processes);
    reply.Regions = Classify(reply.Result, job.Solid, job.Processes);
    DropSolid(reply.Result, reply.Regions);
    reporter.End();
  }
}

/** The services of this program for strategies, which drop the solid before they write. */
StrategyHost HostOf(
  const Job& job, Reply& reply, Reporter& reporter, const std::function<bool()>& write)
{
  return { [&](Stage stage) { reporter.Begin(stage); },
    [&](double fraction) { return reporter.Report(fraction); }, [&] { reporter.End(); },
    [&, write]
    {
      PrepareCracksOf(job, reply, reporter);
      DropSolidOf(job, reply, reporter);
      return write();
    } };
}

/** Returns whether a reply has been written. */
bool TetrahedralizeGiven(const Job& job, Reply& reply, const std::function<bool()>& write)
{
  Reporter reporter(reply);
  CleanGiven(job, reply, reporter);
  return TryStrategies(job, reply, HostOf(job, reply, reporter, write)) || write();
}

void TriangulateGiven(const Job& job, Reply& reply)
{
  Reporter reporter(reply);
  reporter.Begin(Stage::Clean);
  Contours contours = Clean(AsContours(job.Contours, false));
  reporter.End();
  reporter.Begin(Stage::Resolve);
  reply.Error = Resolve(
    contours, reply.IntersectingPairs, [&](double fraction) { return reporter.Report(fraction); });
  if (reply.Error.empty() && job.Initial == InitialApproximation::Custom)
  {
    reply.Error = InsertInitialContour(job.InitialContours, contours);
  }
  reporter.End();
  if (reply.Error.empty())
  {
    reporter.Begin(Stage::Tetrahedralize);
    reply.Strategy = "CGAL constrained Delaunay";
    reply.Error = Triangulate(contours, job.Initial, job.Contours, reply.Plane);
    reporter.End();
  }
}

void DecimateGiven(const Job& job, Reply& reply)
{
  Reporter reporter(reply);
  reporter.Begin(Stage::Tetrahedralize); // the main stage of a job
  reply.Error = DecimateEnclosing(
    job.Surface.Triangles.empty() ? job.Mesh : job.Surface, job.Mesh, job.Parts, job.Decimation,
    reply.Decimation, [&](double fraction) { return reporter.Report(fraction); }, job.Processes);
  reporter.End();
}

/** Does a job of any kind. Returns whether a reply has been written. */
bool DoJob(const Job& job, Reply& reply, const std::function<bool()>& write)
{
  switch (job.Kind)
  {
    case JobKind::Tetrahedralize:
      return TetrahedralizeGiven(job, reply, write);
    case JobKind::CountIntersections:
      CountIntersections(job, reply);
      return write();
    case JobKind::Triangulate:
      TriangulateGiven(job, reply);
      return write();
    case JobKind::Decimate:
      DecimateGiven(job, reply);
      return write();
  }
  return false;
}

/** Returns an empty string, or an error. */
std::string ReadJob(const HostLink& link, Job& job)
{
  std::ifstream in(link.JobPath, std::ios::binary | std::ios::ate);
  const std::streamoff size = std::max<std::streamoff>(in.tellg(), 0); // -1 if there is no file
  std::vector<char> input = MakeLarge<char>(static_cast<std::size_t>(size));
  in.seekg(0);
  in.read(input.data(), size);
  return Read(input.data(), static_cast<std::size_t>(in.gcount()), job);
}

/** Writes the reply, over any that a child process whose work failed has written. */
bool WriteReply(const HostLink& link, Reply& reply)
{
  if (!reply.Error.empty())
  {
    reply.Result = {};
    reply.Regions = {};
    reply.Plane = {};
    reply.Decimation = {};
  }
  std::ofstream out(link.ReplyPath, std::ios::binary);
  Write(out, reply);
  out.close();
  if (!out)
  {
    std::cerr << "carving-helper: the reply could not be written: " << std::strerror(errno) << "\n";
    return false;
  }
  return true;
}

/** Does a part of a job that another run of this program has begun. */
bool Resume(std::istream& in, const HostLink& link)
{
  Job job;
  Reply reply;
  Reporter reporter(reply);
  return ResumeStrategies(
    in, job, reply, HostOf(job, reply, reporter, [&] { return WriteReply(link, reply); }));
}

} // namespace

int main(int argc, char* argv[])
{
  UseLargePagesForAll(argv);
  const HostLink link = ConnectToHost(argc, argv);
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ); // TetGen's words
  BeginProgram(argc, argv, link.ReplyPath, [&](std::istream& in) { return Resume(in, link); });

  Job job;
  const std::string mistake = ReadJob(link, job);
  if (!mistake.empty())
  {
    std::cerr << "carving-helper: " << mistake
              << "\nIt is started by TopologyCarving's filters, which give it a job.\n";
    return 2;
  }
  Reply reply;
  bool written = false;
  const auto write = [&] { return WriteReply(link, reply); };
  LimitMemory(job.MemoryLimit);
  try
  {
    written = DoJob(job, reply, write);
  }
  catch (const std::bad_alloc&)
  {
    reply = {};
    reply.StageSeconds.assign(NumberOfStages, 0.0);
    reply.Error =
      "carving-helper ran out of memory. Raise MemoryLimit if it is set, or simplify the mesh.";
    written = write();
  }
  return written ? 0 : 2;
}
