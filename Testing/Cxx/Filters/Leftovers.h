// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Faults that a test can provoke, and detection of processes and files that they leave behind.
 */
#ifndef Leftovers_h
#define Leftovers_h

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/**
 * During its lifetime, processes that lose their parent become children of this process, temporary
 * files go to a folder of their own, and files that stay open are counted.
 */
class Leftovers
{
public:
  Leftovers()
    : Folder(testing::TempDir() + "leftovers-" + std::to_string(getpid()))
    , OpenBefore(CountEntries("/proc/self/fd"))
  {
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    std::filesystem::create_directory(this->Folder);
    setenv("TMPDIR", this->Folder.c_str(), 1);
  }
  ~Leftovers()
  {
    unsetenv("TMPDIR");
    prctl(PR_SET_CHILD_SUBREAPER, 0);
    std::filesystem::remove_all(this->Folder);
  }
  Leftovers(const Leftovers&) = delete;
  void operator=(const Leftovers&) = delete;

  void ExpectNone() const
  {
    ExpectAllProcessesKilled();
    EXPECT_EQ(CountEntries(this->Folder), 0);
    EXPECT_EQ(CountEntries("/proc/self/fd"), this->OpenBefore);
  }

private:
  static std::ptrdiff_t CountEntries(const std::string& folder)
  {
    return std::distance(
      std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
  }

  /** Expects that remaining processes have been killed, and so end without finishing their work. */
  static void ExpectAllProcessesKilled()
  {
    int status = 0;
    while (waitpid(-1, &status, 0) > 0)
    {
      EXPECT_TRUE(WIFSIGNALED(status)) << status;
    }
    EXPECT_EQ(errno, ECHILD);
  }

  std::string Folder;
  std::ptrdiff_t OpenBefore;
};

/** During its lifetime, a resource of this process and its child processes is limited. */
class ResourceLimit
{
public:
  ResourceLimit(__rlimit_resource_t resource, rlim_t most)
    : Resource(resource)
  {
    signal(SIGXFSZ, SIG_IGN); // would end a process that makes a file too long
    getrlimit(resource, &this->Before);
    const rlimit limit = { most, this->Before.rlim_max };
    setrlimit(resource, &limit);
  }
  ~ResourceLimit()
  {
    setrlimit(this->Resource, &this->Before);
    signal(SIGXFSZ, SIG_DFL);
  }
  ResourceLimit(const ResourceLimit&) = delete;
  void operator=(const ResourceLimit&) = delete;

private:
  __rlimit_resource_t Resource;
  rlimit Before = {};
};

#endif
