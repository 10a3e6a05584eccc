// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Apart.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

constexpr std::size_t Size = 8192;
constexpr int Failed = 3;
constexpr int OutOfMemory = 4;

void Limit(const Limits& limits)
{
  if (limits.Seconds > 0.0)
  {
    const double seconds = std::min(limits.Seconds, 1e9); // what the timer can count
    const double whole = std::floor(seconds);
    itimerval timer = {};
    timer.it_value.tv_sec = static_cast<time_t>(whole);
    timer.it_value.tv_usec = static_cast<suseconds_t>(999998.0 * (seconds - whole)) + 1;
    setitimer(ITIMER_REAL, &timer, nullptr); // its signal ends the process
  }
  LimitMemory(limits.Mebibytes);
}

std::string Describe(int status, const Limits& limits)
{
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
  {
    char text[64];
    std::snprintf(text, sizeof(text), "took longer than %g s", limits.Seconds);
    return text;
  }
  if (WIFSIGNALED(status))
  {
    return std::string("crashed (") + strsignal(WTERMSIG(status)) + ")";
  }
  switch (WEXITSTATUS(status))
  {
    case 0:
      return "";
    case OutOfMemory:
      return "ran out of memory";
    default:
      return "failed";
  }
}

} // namespace

void LimitMemory(double mebibytes)
{
  if (mebibytes > 0.0)
  {
    const rlim_t bytes = static_cast<rlim_t>(std::min(mebibytes * 1024.0 * 1024.0, 1e18));
    const rlimit limit = { bytes, bytes };
    setrlimit(RLIMIT_AS, &limit);
  }
}

std::string RunApart(const Limits& limits, const std::function<bool()>& work)
{
  std::fflush(nullptr);
  std::cout.flush();
  const pid_t self = getpid();
  const pid_t child = fork();
  if (child < 0)
  {
    return "could not be started: " + std::string(std::strerror(errno));
  }
  if (child == 0)
  {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != self)
    {
      _exit(Failed); // it died before it could have been a signal
    }
    // A crash is to end it by a signal, which can be named, whoever has put a handler there.
    for (const int crash : { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT })
    {
      std::signal(crash, SIG_DFL);
    }
    Limit(limits);
    int code = OutOfMemory;
    try
    {
      code = work() ? 0 : Failed;
    }
    catch (const std::bad_alloc&)
    {
    }
    std::fflush(nullptr);
    _exit(code); // destructors are the parent's
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  return Describe(status, limits);
}

Messages::Messages()
  : Shared(static_cast<char*>(
      mmap(nullptr, Size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)))
{
  if (this->Shared == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
}

Messages::~Messages()
{
  munmap(this->Shared, Size);
}

void Messages::Add(const std::string& line)
{
  const std::size_t length = std::strlen(this->Shared);
  std::snprintf(this->Shared + length, Size - length, "%s\n", line.c_str());
}

std::string Messages::Get() const
{
  return this->Shared;
}
