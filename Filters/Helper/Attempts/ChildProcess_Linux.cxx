// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/ChildProcess.h"

#include "Helper/Attempts/ChildExit.h"
#include "Helper/Attempts/Meanwhile.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace carving::helper
{
namespace
{

double ToSeconds(const timeval& time)
{
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/** Starts a timer that ends the process by a signal: SIGALRM or SIGPROF. */
void SetTimer(decltype(ITIMER_REAL) which, double seconds)
{
  const double counted = std::min(seconds, 1e9); // the timer's range
  const double whole = std::floor(counted);
  itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>(999998.0 * (counted - whole)) + 1;
  setitimer(which, &timer, nullptr);
}

/** The rest of this process's limit of processor time; infinite if there is no limit. */
double RemainingProcessorSeconds()
{
  itimerval timer = {};
  getitimer(ITIMER_PROF, &timer);
  const double remaining = ToSeconds(timer.it_value);
  return remaining > 0.0 ? remaining : HUGE_VAL;
}

void Limit(const Limits& limits, double processorSeconds)
{
  if (limits.Seconds > 0.0)
  {
    SetTimer(ITIMER_REAL, limits.Seconds);
  }
  if (processorSeconds < HUGE_VAL)
  {
    SetTimer(ITIMER_PROF, processorSeconds);
  }
  LimitMemory(limits.Mebibytes);
}

bool IsEndedBy(int signal, int status)
{
  return WIFSIGNALED(status) && WTERMSIG(status) == signal;
}

Ending Describe(int status, const Limits& limits)
{
  if (IsEndedBy(SIGALRM, status) || IsEndedBy(SIGPROF, status))
  {
    return IsEndedBy(SIGALRM, status) ? TookTooLong(limits.Seconds, "")
                                      : TookTooLong(limits.ProcessorSeconds, " of processor time");
  }
  if (IsEndedBy(SIGKILL, status)) // by the system, when memory runs out
  {
    return { "was killed", true };
  }
  if (WIFSIGNALED(status))
  {
    return { std::string("crashed (") + strsignal(WTERMSIG(status)) + ")" };
  }
  return DescribeExit(WEXITSTATUS(status));
}

/**
 * Restores the default actions, since a crash or a limit must end the child although its host may
 * ignore the signal.
 */
void RestoreSignals()
{
  for (const int signal : { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGPROF })
  {
    std::signal(signal, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

/**
 * An exception other than for memory ends the child at once: the callers' frames are the parent's.
 */
[[noreturn]] void RunChild(pid_t parent, const Limits& limits, double processorSeconds,
  const std::function<bool()>& work) noexcept
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
  {
    _exit(ExitFailed); // the parent died before its death could send the signal
  }
  RestoreSignals();
  Limit(limits, processorSeconds);
  int code = ExitOutOfMemory;
  try
  {
    code = work() ? 0 : ExitFailed;
  }
  catch (const std::bad_alloc&)
  {
  }
  std::fflush(nullptr);
  _exit(code); // without destructors, which are the parent's
}

/**
 * Subtracts the processor time of a child from the limit of this process, and ends this process if
 * none remains.
 */
void ChargeProcessorTime(double seconds, bool usedUp)
{
  const double rest = RemainingProcessorSeconds() - seconds;
  if (usedUp || rest <= 0.0)
  {
    std::raise(SIGPROF); // as this process's own timer would
  }
  SetTimer(ITIMER_PROF, rest);
}

} // namespace

void BeginProgram(int, char*[], const std::string&, const std::function<bool(std::istream&)>&)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool ChildProcessesEndWithThis()
{
  return true; // RunChild asks for the signal
}

void LimitMemory(double mebibytes)
{
  if (mebibytes > 0.0)
  {
    const rlim_t bytes = static_cast<rlim_t>(std::min(mebibytes * 1024.0 * 1024.0, 1e18));
    const rlimit limit = { bytes, bytes };
    setrlimit(RLIMIT_AS, &limit);
  }
}

Ending RunInChildProcess(
  const Limits& limits, const Work& work, const std::function<bool()>& meanwhile)
{
  std::fflush(nullptr);
  std::cout.flush();
  const double remaining = RemainingProcessorSeconds();
  const double own = limits.ProcessorSeconds > 0.0 ? limits.ProcessorSeconds : HUGE_VAL;
  const pid_t self = getpid();
  const pid_t child = fork();
  if (child < 0)
  {
    return EndWithoutChild(meanwhile, std::strerror(errno));
  }
  if (child == 0)
  {
    RunChild(self, limits, std::min(own, remaining), work.Do);
  }
  const Meanwhile beside(meanwhile);
  if (!beside.WantsChild())
  {
    kill(child, SIGKILL);
  }
  int status = 0;
  rusage used = {};
  while (wait4(child, &status, 0, &used) < 0 && errno == EINTR)
  {
  }
  beside.ThrowFailure();
  if (!beside.WantsChild())
  {
    return { NotWanted };
  }
  const double seconds = ToSeconds(used.ru_utime) + ToSeconds(used.ru_stime);
  if (remaining < HUGE_VAL)
  {
    ChargeProcessorTime(seconds, remaining <= own && IsEndedBy(SIGPROF, status));
  }
  Ending ending = Describe(status, limits);
  ending.ProcessorSeconds = seconds;
  return ending;
}

} // namespace carving::helper
