// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs the helper program as a child process, so that no crash of it affects the host.
 */
#ifndef HelperProcess_h
#define HelperProcess_h

#include "Core/Protocol/Protocol.h"
#include "vtkTopologyCarvingModule.h" // for export macro

#include <functional>
#include <memory>
#include <string>

/**
 * A run of carving-helper. The environment variable TOPOLOGYCARVING_HELPER names the program;
 * without it, the program is the one that was built or installed with this library. On Linux, no
 * file is written to a disk; elsewhere, temporary files are, which vanish with this object.
 */
class VTKTOPOLOGYCARVING_EXPORT HelperProcess
{
public:
  enum class Outcome
  {
    Success,
    Failure,
    Aborted
  };

  /** Is called with the progress of the work. Returns false to abort. */
  using Observer = std::function<bool(const carving::WorkProgress&)>;

  HelperProcess();
  /** Kills the program if it still runs. */
  ~HelperProcess();
  HelperProcess(HelperProcess&&) noexcept;
  HelperProcess& operator=(HelperProcess&&) noexcept;

  /** Starts the program with a job. Returns an empty string, or a sentence on what is wrong. */
  std::string Start(const carving::Job& job);

  /** Whether the program, which has been started, still runs. Does not wait. */
  bool IsRunning();

  /**
   * Waits for the end of the program, which has been started, and reads its reply.
   *
   * `observer` is called with every progress of the work, and at least ten times a second. If it
   * returns false, the program is killed at once. After a Failure, `error` is a sentence on the
   * reason.
   */
  Outcome Wait(const Observer& observer, carving::Reply& reply, std::string& error);

  /** Starts the program and waits for its end. */
  static Outcome Run(
    const carving::Job& job, carving::Reply& reply, const Observer& observer, std::string& error);

private:
  class Program;
  std::unique_ptr<Program> Running;
};

#endif
