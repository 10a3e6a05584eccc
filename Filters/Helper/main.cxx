// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * carving-helper: reads a job from standard input and writes the reply to standard output, in the
 * format of Protocol.h. The exit code is 0 if there is a reply, even one with an error, and 2 if
 * there is none.
 */
#include "Core/Protocol/Protocol.h"
#include "Core/Protocol/SecondsSince.h"
#include "Helper/Attempts/ChildProcess.h"
#include "Helper/Attempts/Strategies.h"
#include "Helper/Decimation/EnclosingDecimation.h"
#include "Helper/Plane/InitialContour.h"
#include "Helper/Plane/Triangulate.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Intersections.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iostream>
#include <new>

#include <sys/prctl.h>
#include <unistd.h>

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

/** Returns whether a reply has been written. */
bool TetrahedralizeGiven(const Job& job, Reply& reply, const std::function<bool()>& write)
{
  Reporter reporter(reply);
  CleanGiven(job, reply, reporter);
  const StrategyHost host = { [&](Stage stage) { reporter.Begin(stage); },
    [&](double fraction) { return reporter.Report(fraction); }, [&] { reporter.End(); }, write };
  return TryStrategies(job, reply, host) || write();
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
  reply.Error = DecimateEnclosing(job.Surface.Triangles.empty() ? job.Mesh : job.Surface, job.Mesh,
    job.Decimation, reply.Decimation, [&](double fraction) { return reporter.Report(fraction); });
  reporter.End();
}

/** Does a job of any kind. Returns whether a reply has been written. */
bool Work(const Job& job, Reply& reply, const std::function<bool()>& write)
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

std::string ReadAll(std::istream& in)
{
  std::string all;
  std::vector<char> chunk(1 << 20);
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0)
  {
    all.append(chunk.data(), static_cast<std::size_t>(in.gcount()));
  }
  return all;
}

/** Returns an empty string, or an error. */
std::string ReadJob(Job& job)
{
  const std::string input = ReadAll(std::cin);
  return Read(input.data(), input.size(), job);
}

/**
 * Writes the reply from the beginning of its file, over anything that a failed child process has
 * written.
 */
bool WriteReply(int descriptor, Reply& reply)
{
  if (!reply.Error.empty())
  {
    reply.Result = {};
    reply.Plane = {};
    reply.Decimation = {};
  }
  std::fflush(stdout);
  dup2(descriptor, STDOUT_FILENO);
  // Both fail on a pipe, where nothing has been written before.
  lseek(STDOUT_FILENO, 0, SEEK_SET);
  const int truncated = ftruncate(STDOUT_FILENO, 0);
  static_cast<void>(truncated);
  Write(std::cout, reply);
  std::cout.flush();
  if (!std::cout)
  {
    std::cerr << "carving-helper: the reply could not be written: " << std::strerror(errno) << "\n";
    std::cout.clear();
    return false;
  }
  return true;
}

} // namespace

int main()
{
  prctl(PR_SET_PDEATHSIG, SIGKILL); // the helper ends with its host
  std::signal(SIGXFSZ, SIG_IGN);    // beyond a limit on file sizes, writing the reply fails instead
  // Standard output is reserved for the reply: TetGen's output is redirected to standard error.
  const int replyDescriptor = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  setvbuf(stdout, nullptr, _IOLBF, 0);

  std::ios::sync_with_stdio(false);
  Job job;
  const std::string mistake = ReadJob(job);
  if (!mistake.empty())
  {
    std::cerr << "carving-helper: " << mistake
              << "\nIt is started by TopologyCarving's filters and reads their job from standard "
                 "input.\n";
    return 2;
  }
  Reply reply;
  bool written = false;
  const auto write = [&] { return WriteReply(replyDescriptor, reply); };
  LimitMemory(job.MemoryLimit);
  try
  {
    written = Work(job, reply, write);
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
