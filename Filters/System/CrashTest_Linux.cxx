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
  const pid_t copy = fork();
  if (copy == 0)
  {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    Silence();
    Do(work);
    _exit(0);
  }
  int status = 0;
  pid_t ended = -1;
  while (copy > 0 && (ended = waitpid(copy, &status, 0)) < 0 && errno == EINTR)
  {
  }
  return ended == copy && status != 0; // readers may also end their process
}
