// SPDX-License-Identifier: BSD-3-Clause
#include "Helper/Attempts/ChildProcess.h"
#include "Helper/Attempts/Log.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <new>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

using namespace carving::helper;

namespace
{

Limits ByClock(double seconds)
{
  return { seconds, 0.0, 0.0 };
}

Limits ByProcessor(double seconds)
{
  return { 0.0, seconds, 0.0 };
}

Limits ByMemory(double mebibytes)
{
  return { 0.0, 0.0, mebibytes };
}

/** How work in a child process ended. */
std::string EndOf(const Limits& limits, const std::function<bool()>& work)
{
  return RunInChildProcess(limits, work).Mistake;
}

bool Hang()
{
  for (;;)
  {
    pause();
  }
}

/** Computes until this process has used so many seconds of processor time. */
bool Compute(double seconds)
{
  while (static_cast<double>(std::clock()) < seconds * CLOCKS_PER_SEC)
  {
  }
  return true;
}

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
TEST(ChildProcess, HasNoMistakeOnSuccess)
{
  Messages messages;
  EXPECT_EQ(EndOf({},
              [&]
              {
                messages.Add("one");
                messages.Add("two");
                return true;
              }),
    "");
  EXPECT_EQ(messages.Get(), "one\ntwo\n");
}

// Changes that the work makes to memory are lost.
TEST(ChildProcess, LeavesMemoryUnchanged)
{
  int number = 1;
  EXPECT_EQ(EndOf({},
              [&]
              {
                number = 2;
                return false;
              }),
    "failed");
  EXPECT_EQ(number, 1);
}

// A crash becomes a message, and this process continues.
TEST(ChildProcess, SurvivesACrash)
{
  const std::string end = EndOf({},
    []
    {
      std::abort();
      return true;
    });
  EXPECT_EQ(end, "crashed (Aborted)");
}

// Work that hangs is ended by the limit on clock time.
TEST(ChildProcess, EndsWorkThatHangs)
{
  EXPECT_EQ(EndOf(ByClock(0.2), &Hang), "took longer than 0.2 s");
}

// Sleep is not processor time.
TEST(ChildProcess, DoesNotCountSleep)
{
  const std::string end = EndOf(ByProcessor(0.1),
    []
    {
      usleep(500000);
      return true;
    });
  EXPECT_EQ(end, "");
}

// The time of other processes is not processor time of this one.
TEST(ChildProcess, DoesNotCountTheTimeOfOthers)
{
  const OneBusyProcessor others(4);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(EndOf(ByProcessor(0.4), [] { return Compute(0.2); }), "");
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_GT(seconds.count(), 0.4);
}

// Work that computes too long is ended by the limit on processor time.
TEST(ChildProcess, EndsWorkThatComputesTooLong)
{
  const std::string end = EndOf(ByProcessor(0.2), [] { return Compute(HUGE_VAL); });
  EXPECT_EQ(end, "took longer than 0.2 s of processor time");
}

// The processor time of a nested child is charged to its parent.
TEST(ChildProcess, ChargesNestedChildren)
{
  const std::string end = EndOf(ByProcessor(0.5),
    []
    {
      for (int i = 0; i < 4; ++i)
      {
        EndOf({}, [] { return Compute(0.2); });
      }
      return true;
    });
  EXPECT_EQ(end, "took longer than 0.5 s of processor time");
}

// A nested child gets no more than the rest of its parent's processor time, whatever its own limit.
TEST(ChildProcess, LimitsNestedChildrenToTheRest)
{
  for (const double limit : { 0.0, 1000.0 })
  {
    const std::string end = EndOf(ByProcessor(0.2),
      [&]
      {
        EndOf(ByProcessor(limit), [] { return Compute(HUGE_VAL); });
        return true;
      });
    EXPECT_EQ(end, "took longer than 0.2 s of processor time");
  }
}

// A parent continues after the own limit of a nested child has ended that child.
TEST(ChildProcess, OutlivesNestedChildren)
{
  Messages messages;
  const std::string end = EndOf(ByProcessor(1000.0),
    [&]
    {
      messages.Add(EndOf(ByProcessor(0.1), [] { return Compute(HUGE_VAL); }));
      return true;
    });
  EXPECT_EQ(end, "");
  EXPECT_EQ(messages.Get(), "took longer than 0.1 s of processor time\n");
}

// Limits hold even if the host blocks or ignores the signals that enforce them, as thread pools do.
TEST(ChildProcess, HoldsLimitsAgainstIgnoredSignals)
{
  EXPECT_EQ(EndOf({},
              []
              {
                sigset_t all;
                sigfillset(&all);
                sigprocmask(SIG_SETMASK, &all, nullptr);
                std::signal(SIGALRM, SIG_IGN);
                std::signal(SIGPROF, SIG_IGN);
                return EndOf(ByClock(0.2), &Hang) == "took longer than 0.2 s" &&
                  EndOf(ByProcessor(0.2), [] { return Compute(HUGE_VAL); }) ==
                  "took longer than 0.2 s of processor time";
              }),
    "");
}

#ifndef __SANITIZE_ADDRESS__ // the sanitizer reserves more address space than any limit
// Work that exceeds the limit on memory fails with a message.
TEST(ChildProcess, LimitsMemory)
{
  const std::string end = EndOf(ByMemory(256.0),
    []
    {
      const std::vector<char> much(std::size_t(1) << 30, 1);
      return much.size() > 1;
    });
  EXPECT_EQ(end, "ran out of memory");
}
#endif

// An end by a limit, even by one of the machine, is distinguished from other failures.
TEST(ChildProcess, DistinguishesLimitsFromOtherEnds)
{
  const auto dieOf = [](int signal) { return [signal] { return std::raise(signal) != 0; }; };
  EXPECT_TRUE(RunInChildProcess(ByClock(0.01), &Hang).ByLimit);
  EXPECT_TRUE(RunInChildProcess(ByProcessor(0.01), [] { return Compute(HUGE_VAL); }).ByLimit);
  EXPECT_TRUE(RunInChildProcess({}, []() -> bool { throw std::bad_alloc(); }).ByLimit);
  EXPECT_TRUE(
    RunInChildProcess({}, dieOf(SIGKILL)).ByLimit); // the system's signal when memory runs out
  EXPECT_FALSE(RunInChildProcess({}, dieOf(SIGSEGV)).ByLimit);
  EXPECT_FALSE(RunInChildProcess({}, [] { return false; }).ByLimit);
}

// Messages of nested children arrive, too.
TEST(ChildProcess, CanBeNested)
{
  Messages messages;
  const std::string end = EndOf({},
    [&]
    {
      messages.Add(EndOf({},
        []
        {
          std::abort();
          return true;
        }));
      return true;
    });
  EXPECT_EQ(end, "");
  EXPECT_EQ(messages.Get(), "crashed (Aborted)\n");
}
