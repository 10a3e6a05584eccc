// SPDX-License-Identifier: BSD-3-Clause
#include "ChildProcessTesting.h"

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <new>
#include <sched.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace carving::helper;

namespace
{

const ChildWork Succeed("succeed", [] { return true; });
const ChildWork Fail("fail", [] { return false; });
const ChildWork Throw("throw", []() -> bool { throw std::bad_alloc(); });
const ChildWork Fault("fault", [] { return std::raise(SIGSEGV) != 0; });
const ChildWork Abort("abort", []() -> bool { std::abort(); });
const ChildWork Sleep("sleep",
  []
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    return true;
  });
const ChildWork ComputeShortly("compute shortly", [] { return Compute(0.2); });

const ChildWork AddTwoLines("add two lines",
  []
  {
    Added->Add("one");
    Added->Add("two");
    return true;
  });
const ChildWork ComputeShortlyInChildren("compute shortly in children",
  []
  {
    for (int i = 0; i < 4; ++i)
    {
      EndOf({}, ComputeShortly);
    }
    return true;
  });
const ChildWork ComputeInAChild("compute in a child",
  []
  {
    EndOf({}, ComputeForever);
    return true;
  });
const ChildWork ComputeInALimitedChild("compute in a limited child",
  []
  {
    EndOf(ByProcessor(1000.0), ComputeForever);
    return true;
  });
const ChildWork OutliveAChild("outlive a child",
  []
  {
    Added->Add(EndOf(ByProcessor(0.1), ComputeForever));
    return true;
  });
const ChildWork ComputeAndSaySo("compute and say so",
  []
  {
    Compute(1.0);
    Added->Add("has computed");
    return Compute(60.0);
  });
const ChildWork ComputeAfterAChild("compute after a child that is not wanted",
  []
  {
    const auto isWanted = []
    {
      while (Added->Get().empty())
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      return false;
    };
    RunInChildProcess({}, ComputeAndSaySo.Get(), isWanted);
    return Compute(1.0);
  });
const ChildWork AddInAChild("add in a child",
  []
  {
    Added->Add(EndOf({}, AddTwoLines));
    return true;
  });

/** Confines this process and its children to one processor, which busy processes share. */
class OneBusyProcessor
{
public:
  explicit OneBusyProcessor(int numberOfOthers)
  {
    sched_getaffinity(0, sizeof(this->Before), &this->Before);
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof(one), &one);
    for (int i = 0; i < numberOfOthers; ++i)
    {
      this->Others.push_back(fork());
      if (this->Others.back() == 0)
      {
        Compute(60.0); // ends by itself if the test dies
        _exit(0);
      }
    }
  }

  ~OneBusyProcessor()
  {
    for (const pid_t other : this->Others)
    {
      kill(other, SIGKILL);
      waitpid(other, nullptr, 0);
    }
    sched_setaffinity(0, sizeof(this->Before), &this->Before);
  }

  OneBusyProcessor(const OneBusyProcessor&) = delete;
  void operator=(const OneBusyProcessor&) = delete;

private:
  cpu_set_t Before;
  std::vector<pid_t> Others;
};

} // namespace

// Work that succeeds has no mistake, and its messages arrive.
TEST_F(ChildProcess, HasNoMistakeOnSuccess)
{
  EXPECT_EQ(EndOf({}, AddTwoLines), "");
  EXPECT_EQ(Added->Get(), "one\ntwo\n");
}

// Work that fails says so.
TEST_F(ChildProcess, ReportsFailure)
{
  EXPECT_EQ(EndOf({}, Fail), "failed");
}

// A crash becomes a message, and this process continues.
TEST_F(ChildProcess, SurvivesACrash)
{
  const std::string end = EndOf({}, Abort);
  EXPECT_EQ(end.find("crashed ("), 0u) << end;
  EXPECT_NE(end.find("borted)"), std::string::npos) << end;
}

// Work that hangs is ended by the limit on clock time.
TEST_F(ChildProcess, EndsWorkThatHangs)
{
  EXPECT_EQ(EndOf(ByClock(0.2), Hang), "took longer than 0.2 s");
}

// Sleep is not processor time.
TEST_F(ChildProcess, DoesNotCountSleep)
{
  EXPECT_EQ(EndOf(ByProcessor(0.1), Sleep), "");
}

// The time of other processes is not processor time of this one.
TEST_F(ChildProcess, DoesNotCountTheTimeOfOthers)
{
  const OneBusyProcessor others(4);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(EndOf(ByProcessor(0.4), ComputeShortly), "");
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_GT(seconds.count(), 0.4);
}

// Work that computes too long is ended by the limit on processor time.
TEST_F(ChildProcess, EndsWorkThatComputesTooLong)
{
  EXPECT_EQ(EndOf(ByProcessor(0.2), ComputeForever), "took longer than 0.2 s of processor time");
}

// The processor time of a nested child is charged to its parent.
TEST_F(ChildProcess, ChargesNestedChildren)
{
  EXPECT_EQ(
    EndOf(ByProcessor(0.5), ComputeShortlyInChildren), "took longer than 0.5 s of processor time");
}

// The processor time of a child and of its own children is reported. Sleep does not count.
TEST_F(ChildProcess, ReportsProcessorTime)
{
  EXPECT_GE(RunInChildProcess({}, ComputeShortlyInChildren.Get()).ProcessorSeconds, 0.8);
  EXPECT_LT(RunInChildProcess({}, Sleep.Get()).ProcessorSeconds, 0.4);
}

// A nested child gets no more than the rest of its parent's processor time, whatever its own limit.
TEST_F(ChildProcess, LimitsNestedChildrenToTheRest)
{
  for (const ChildWork* work : { &ComputeInAChild, &ComputeInALimitedChild })
  {
    EXPECT_EQ(EndOf(ByProcessor(0.2), *work), "took longer than 0.2 s of processor time");
  }
}

// A parent continues after the own limit of a nested child has ended that child.
TEST_F(ChildProcess, OutlivesNestedChildren)
{
  EXPECT_EQ(EndOf(ByProcessor(1000.0), OutliveAChild), "");
  EXPECT_EQ(Added->Get(), "took longer than 0.1 s of processor time\n");
}

// An end by a limit is distinguished from other failures.
TEST_F(ChildProcess, DistinguishesLimitsFromOtherEnds)
{
  EXPECT_TRUE(RunInChildProcess(ByClock(0.01), Hang.Get()).ByLimit);
  EXPECT_TRUE(RunInChildProcess(ByProcessor(0.01), ComputeForever.Get()).ByLimit);
  EXPECT_TRUE(RunInChildProcess({}, Throw.Get()).ByLimit);
  EXPECT_FALSE(RunInChildProcess({}, Fault.Get()).ByLimit);
  EXPECT_FALSE(RunInChildProcess({}, Fail.Get()).ByLimit);
}

// A child that turns out not to be wanted is killed; one that stays wanted goes on to its end.
TEST_F(ChildProcess, IsKilledWhereNotWanted)
{
  const Ending killed = RunInChildProcess({}, Hang.Get(), [] { return false; });
  EXPECT_EQ(killed.Mistake, NotWanted);
  EXPECT_FALSE(killed.ByLimit);
  bool called = false;
  const auto stillWanted = [&] { return called = true; };
  EXPECT_EQ(RunInChildProcess({}, Succeed.Get(), stillWanted).Mistake, "");
  EXPECT_TRUE(called);
}

// A child does not outlive an exception in its parent, which is passed on.
TEST_F(ChildProcess, IsKilledWhereItsParentThrows)
{
  const auto runOut = []() -> bool { throw std::bad_alloc(); };
  EXPECT_THROW(RunInChildProcess({}, Hang.Get(), runOut), std::bad_alloc);
  EXPECT_EQ(waitpid(-1, nullptr, 0), -1);
}

// The time of a child that is not wanted is not charged to its parent.
TEST_F(ChildProcess, DoesNotChargeWorkThatIsNotWanted)
{
  EXPECT_EQ(EndOf(ByProcessor(1.5), ComputeAfterAChild), "");
}

// Messages of nested children arrive, too.
TEST_F(ChildProcess, CanBeNested)
{
  EXPECT_EQ(EndOf({}, AddInAChild), "");
  EXPECT_EQ(Added->Get(), "one\ntwo\n\n");
}
