// SPDX-License-Identifier: BSD-3-Clause
#include "System/CrashTest.h"

#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

/** Neither messages nor a core file of the copy are of interest. */
void Silence()
{
  const rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

/** No exception leaves the copy's part of the program. */
void Do(const std::function<void()>& work) noexcept
{
  work();
}

} // namespace

bool Crashes(const std::function<void()>& work)
{
  int ends[2]; // of a pipe
  if (pipe2(ends, O_CLOEXEC) != 0)
  {
    return false;
  }
  const auto [toRead, toWrite] = ends;
  const pid_t copy = fork();
  if (copy == 0)
  {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    Silence();
    Do(work);
    _exit(write(toWrite, "", 1) == 1 ? 0 : 1); // readers may also end their process before
  }
  close(toWrite);
  // Not the status: where SIGCHLD is ignored, which programs inherit, there is none.
  char done = 0;
  ssize_t count = 0;
  while (copy > 0 && (count = read(toRead, &done, 1)) < 0 && errno == EINTR)
  {
  }
  close(toRead);
  while (copy > 0 && waitpid(copy, nullptr, 0) < 0 && errno == EINTR)
  {
  }
  return copy > 0 && count == 0;
}
