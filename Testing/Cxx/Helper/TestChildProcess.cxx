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

namespace
{

Limits ByClock(double seconds)
{
  Limits limits;
  limits.Seconds = seconds;
  return limits;
}

Limits ByProcessor(double seconds)
{
  Limits limits;
  limits.ProcessorSeconds = seconds;
  return limits;
}

Limits ByMemory(double mebibytes)
{
  Limits limits;
  limits.Mebibytes = mebibytes;
  return limits;
}

/** What has ended work that was run apart. */
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

/** Takes so many seconds of processor time. */
bool Compute(double seconds)
{
  while (static_cast<double>(std::clock()) < seconds * CLOCKS_PER_SEC)
  {
  }
  return true;
}

/** Leaves this process, and what it runs, one processor, and that to be shared with busy others. */
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
        Compute(60.0); // should nobody end it
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

// Work that succeeds says nothing; what it leaves as message arrives.
TEST(ChildProcess, SaysNothingOfSuccess)
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

// What it changes here stays as it was.
TEST(ChildProcess, ChangesNothingHere)
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

// A crash is a sentence, and this process goes on.
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

// What hangs is ended when its time by the clock is over.
TEST(ChildProcess, EndsWhatHangs)
{
  const std::string end = EndOf(ByClock(0.2), &Hang);
  EXPECT_EQ(end, "took longer than 0.2 s");
}

// Time in which it does not compute is no processor time.
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

// Time in which others have the processor is no processor time.
TEST(ChildProcess, DoesNotCountTheTimeOfOthers)
{
  const OneBusyProcessor others(4);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(EndOf(ByProcessor(0.4), [] { return Compute(0.2); }), "");
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_GT(seconds.count(), 0.4);
}

// What computes for longer than its processor time is ended.
TEST(ChildProcess, EndsWhatComputesTooLong)
{
  const std::string end = EndOf(ByProcessor(0.2), [] { return Compute(HUGE_VAL); });
  EXPECT_EQ(end, "took longer than 0.2 s of processor time");
}

// What runs apart within it is paid for out of its processor time.
TEST(ChildProcess, CountsTheTimeOfItsOwn)
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

// What runs apart within it has no more processor time than is left, whatever its own limit.
TEST(ChildProcess, GivesItsOwnNoMoreThanIsLeft)
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

// What runs apart within it may come to the end of its own processor time; the other goes on.
TEST(ChildProcess, OutlivesALimitOfItsOwn)
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

// Limits hold although the host blocks or ignores the signals that enforce them, as threads of a pool do.
TEST(ChildProcess, LimitsWhatIgnoresSignals)
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

#ifndef __SANITIZE_ADDRESS__ // which reserves more address space than any limit
// What wants more memory than it may have fails, and this is said.
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

// An end by a limit, the machine's too, is told from any other.
TEST(ChildProcess, TellsLimitsFromOtherEnds)
{
  const auto dieOf = [](int signal) { return [signal] { return std::raise(signal) != 0; }; };
  EXPECT_TRUE(RunInChildProcess(ByClock(0.01), &Hang).ByLimit);
  EXPECT_TRUE(RunInChildProcess(ByProcessor(0.01), [] { return Compute(HUGE_VAL); }).ByLimit);
  EXPECT_TRUE(RunInChildProcess({}, []() -> bool { throw std::bad_alloc(); }).ByLimit);
  EXPECT_TRUE(
    RunInChildProcess({}, dieOf(SIGKILL)).ByLimit); // as the system does where memory runs out
  EXPECT_FALSE(RunInChildProcess({}, dieOf(SIGSEGV)).ByLimit);
  EXPECT_FALSE(RunInChildProcess({}, [] { return false; }).ByLimit);
}

// Processes that run apart can run others apart, whose messages arrive here too.
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
