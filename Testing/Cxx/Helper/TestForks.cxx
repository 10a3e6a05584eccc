// SPDX-License-Identifier: BSD-3-Clause
// What child processes and the strategies that use them promise on Linux alone.
#include "ChildProcessTesting.h"
#include "Helper/Attempts/Messages.h"
#include "Helper/Attempts/Strategies.h"
#include "Helper/Resolve/Clean.h"
#include "Shapes.h"

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

using namespace carving;
using namespace carving::helper;

namespace
{

int Number = 1;
const ChildWork ChangeMemory("change memory",
  []
  {
    Number = 2;
    return false;
  });
const ChildWork BeKilled("be killed", [] { return std::raise(SIGKILL) != 0; });
const ChildWork IgnoreSignals("ignore signals",
  []
  {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, nullptr);
    std::signal(SIGALRM, SIG_IGN);
    std::signal(SIGPROF, SIG_IGN);
    return EndOf(ByClock(0.2), Hang) == "took longer than 0.2 s" &&
      EndOf(ByProcessor(0.2), ComputeForever) == "took longer than 0.2 s of processor time";
  });
const ChildWork ThrowLengthError(
  "throw length error", []() -> bool { throw std::length_error("too long"); });
const ChildWork SleepShortly("sleep shortly",
  []
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    return true;
  });
const ChildWork StartNoChild("start no child",
  []
  {
    const rlimit none = {};
    setrlimit(RLIMIT_NPROC, &none);
    constexpr uid_t anyOther = 65534; // the limit does not hold for root
    bool isCalled = false;
    const auto meanwhile = [&] { return isCalled = true; };
    return (getuid() != 0 || setuid(anyOther) == 0) &&
      RunInChildProcess({}, Hang.Get(), meanwhile).Mistake.find("could not be started: ") == 0 &&
      isCalled;
  });

} // namespace

// An exception in a child ends that child alone, not the one beside it.
TEST_F(ChildProcess, EndsAtAnException)
{
  std::string end;
  const auto failMeanwhile = [&end]
  {
    end = EndOf({}, ThrowLengthError);
    return true;
  };
  const Ending other = RunInChildProcess({}, SleepShortly.Get(), failMeanwhile);
  EXPECT_NE(end.find("crashed"), std::string::npos) << end;
  EXPECT_EQ(other.Mistake, "");
}

// Changes that the work makes to memory are lost.
TEST_F(ChildProcess, LeavesMemoryUnchanged)
{
  EXPECT_EQ(EndOf({}, ChangeMemory), "failed");
  EXPECT_EQ(Number, 1);
}

// Limits hold even if the host blocks or ignores the signals that enforce them, as thread pools do.
TEST_F(ChildProcess, HoldsLimitsAgainstIgnoredSignals)
{
  EXPECT_EQ(EndOf({}, IgnoreSignals), "");
}

#ifndef __SANITIZE_ADDRESS__ // the sanitizer reserves more address space than any limit
namespace
{

const ChildWork TakeMemory("take memory",
  []
  {
    const std::vector<char> much(std::size_t(1) << 30, 1);
    return much.size() > 1;
  });

} // namespace

// Work that exceeds the limit on memory fails with a message.
TEST_F(ChildProcess, LimitsMemory)
{
  EXPECT_EQ(EndOf(ByMemory(256.0), TakeMemory), "ran out of memory");
}
#endif

// An end by the signal that the system sends when memory runs out is one by a limit.
TEST_F(ChildProcess, TakesAKillForALimit)
{
  const Ending ending = RunInChildProcess({}, BeKilled.Get());
  EXPECT_EQ(ending.Mistake, "was killed");
  EXPECT_TRUE(ending.ByLimit);
}

// Where no child can be started, the work beside it is done all the same.
TEST_F(ChildProcess, DoesTheWorkBesideWithoutAChild)
{
  EXPECT_EQ(EndOf({}, StartNoChild), "");
}

// With a free processor, a mesh is enclosed while exact attempts take long.
TEST(StrategiesInForks, EncloseBesideLongAttempts)
{
  Job job;
  job.Mesh = models::Sheared(models::Sphere(1));
  job.Conformity = Conformity::Auto;
  job.Processes = 2;
  Reply reply;
  reply.StageSeconds.assign(NumberOfStages, 0.0);
  reply.Result.Surface = Clean(AsResolved(job.Mesh));
  Messages fractions("fractions");
  const StrategyHost host = { [](Stage) {},
    [&](double fraction)
    {
      if (reply.Strategy == "Delaunay, enclosing")
      {
        fractions.Add(std::to_string(fraction));
      }
      return true;
    },
    [] {},
    [&]
    {
      if (reply.Strategy == "TetGen -pcY")
      {
        // longer than 2.5 s and the time for enclosing 80 triangles
        std::this_thread::sleep_for(std::chrono::seconds(6));
      }
      return reply.Strategy == "Delaunay, enclosing";
    } };
  EXPECT_TRUE(TryStrategies(job, reply, host));
  EXPECT_EQ(fractions.Get(), "1.000000\n"); // done when the attempts had failed
}
