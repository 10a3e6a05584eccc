// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/ChildProcess.h"

#include "Core/Protocol/SecondsSince.h"
#include "Helper/Attempts/ChildExit.h"
#include "Helper/Attempts/Meanwhile.h"
#include "Helper/Attempts/ProgramRun.h"
#include "vtksys/Process.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <new>
#include <thread>
#include <vector>

namespace carving::helper
{
namespace
{

constexpr int ExitTimeIsUp = 5;
constexpr const char* ChildOption = "--child"; ///< followed by stem, depth and processor seconds
constexpr int NumberOfChildArguments = 4;
constexpr double NoLimit = 1e8; ///< seconds, within the range of all systems' clocks

/** This run of the program. */
struct Run
{
  std::vector<std::string> Command; ///< the program with its own arguments
  std::string Stem;
  int Depth = 0; ///< 1: a child process, 2: a child of a child, ...
  double ProcessorSeconds = NoLimit;
  std::atomic<double> UsedByChildren{ 0.0 };
  std::atomic<bool> HasChild{ false };
};
Run ThisRun;

/** The file that is handed to the child process of a depth. */
std::string HandedTo(int depth)
{
  return ThisRun.Stem + "." + std::to_string(depth);
}

/** The file with the processor time that a child process of a depth has used. */
std::string UsedBy(int depth)
{
  return HandedTo(depth) + ".seconds";
}

/**
 * Of this process and its children. Where clock() tells the time since the start, that time counts
 * as used.
 */
double UsedProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC + ThisRun.UsedByChildren;
}

/** Ends a child process without destructors, which another thread might disturb. */
[[noreturn]] void EndChild(int code)
{
  std::fflush(nullptr);
  std::ofstream(UsedBy(ThisRun.Depth)) << UsedProcessorSeconds();
  std::_Exit(code);
}

/**
 * Starts a thread that ends this child process when its processor time is used up. If it has a
 * child itself then, that ends by its own limit first.
 */
void WatchProcessorTime()
{
  std::thread(
    []
    {
      for (;;)
      {
        const double rest = ThisRun.ProcessorSeconds - UsedProcessorSeconds();
        if (rest <= 0.0 && !ThisRun.HasChild)
        {
          EndChild(ExitTimeIsUp);
        }
        // Threads use as much processor time at once as there are processors.
        const double least = rest / std::max(std::thread::hardware_concurrency(), 1u);
        std::this_thread::sleep_for(std::chrono::duration<double>(std::max(least, 1e-2)));
      }
    })
    .detach();
}

[[noreturn]] void RunChild(const std::function<bool(std::istream&)>& resume)
{
  if (ThisRun.ProcessorSeconds < NoLimit)
  {
    WatchProcessorTime();
  }
  int code = ExitOutOfMemory;
  try
  {
    std::ifstream in(HandedTo(ThisRun.Depth), std::ios::binary);
    code = resume(in) ? 0 : ExitFailed;
  }
  catch (const std::bad_alloc&)
  {
  }
  EndChild(code);
}

/** The command for a child process. */
std::vector<std::string> ChildCommand(double processorSeconds)
{
  std::vector<std::string> command = ThisRun.Command;
  command.insert(command.end(),
    { ChildOption, ThisRun.Stem, std::to_string(ThisRun.Depth + 1),
      std::to_string(processorSeconds) });
  return command;
}

bool HasUsedUpItsTime(vtksysProcess* process)
{
  return vtksysProcess_GetState(process) == vtksysProcess_State_Exited &&
    vtksysProcess_GetExitValue(process) == ExitTimeIsUp;
}

Ending Describe(vtksysProcess* process, const Limits& limits)
{
  switch (vtksysProcess_GetState(process))
  {
    case vtksysProcess_State_Exited:
      return HasUsedUpItsTime(process) ? TookTooLong(limits.ProcessorSeconds, " of processor time")
                                       : DescribeExit(vtksysProcess_GetExitValue(process));
    case vtksysProcess_State_Expired:
      return TookTooLong(limits.Seconds, "");
    case vtksysProcess_State_Exception:
      return { std::string("crashed (") + vtksysProcess_GetExceptionString(process) + ")" };
    default:
      return { std::string("could not be started: ") + vtksysProcess_GetErrorString(process),
        true };
  }
}

/** Starts a command, whose output is that of this process. */
void Start(vtksysProcess* process, const std::vector<std::string>& command, double seconds)
{
  std::vector<const char*> arguments;
  for (const std::string& argument : command)
  {
    arguments.push_back(argument.c_str());
  }
  arguments.push_back(nullptr);
  vtksysProcess_SetCommand(process, arguments.data());
  vtksysProcess_SetPipeShared(process, vtksysProcess_Pipe_STDOUT, 1);
  vtksysProcess_SetPipeShared(process, vtksysProcess_Pipe_STDERR, 1);
  vtksysProcess_SetTimeout(process, std::min(seconds, NoLimit));
  vtksysProcess_Execute(process);
}

/** Returns whether the work could be written. */
bool HandOver(const Work& work, const std::string& fileName)
{
  std::ofstream out(fileName, std::ios::binary);
  work.Write(out);
  out.close();
  return !!out;
}

/**
 * Takes the processor time of a child process, which ended after so many seconds, for used, and
 * ends this process if none remains. Returns the child's time.
 */
double ChargeProcessorTime(const std::string& fileName, double elapsed, bool usedUp)
{
  double used = 0.0;
  const bool known = !!(std::ifstream(fileName) >> used);
  std::remove(fileName.c_str());
  const double seconds = known ? used : elapsed;
  ThisRun.UsedByChildren = ThisRun.UsedByChildren + seconds;
  if (usedUp || UsedProcessorSeconds() >= ThisRun.ProcessorSeconds)
  {
    EndChild(ExitTimeIsUp); // as this process's own thread would
  }
  return seconds;
}

} // namespace

Ending RunInChildProcess(
  const Limits& limits, const Work& work, const std::function<bool()>& meanwhile)
{
  std::fflush(nullptr);
  const std::string handed = HandedTo(ThisRun.Depth + 1), used = UsedBy(ThisRun.Depth + 1);
  std::remove(used.c_str()); // of a child whose parent was ended
  if (!HandOver(work, handed))
  {
    std::remove(handed.c_str());
    return EndWithoutChild(meanwhile, "its input could not be written");
  }
  const double remaining = ThisRun.ProcessorSeconds - UsedProcessorSeconds();
  const double own = limits.ProcessorSeconds > 0.0 ? limits.ProcessorSeconds : NoLimit;
  const std::unique_ptr<vtksysProcess, void (*)(vtksysProcess*)> process{ vtksysProcess_New(),
    vtksysProcess_Delete };
  const auto start = std::chrono::steady_clock::now();
  ThisRun.HasChild = true;
  Start(process.get(), ChildCommand(std::min(own, remaining)), limits.Seconds);
  const Meanwhile beside(meanwhile);
  if (!beside.WantsChild())
  {
    vtksysProcess_Kill(process.get());
  }
  vtksysProcess_WaitForExit(process.get(), nullptr);
  ThisRun.HasChild = false;
  std::remove(handed.c_str());
  if (!beside.WantsChild())
  {
    std::remove(used.c_str());
    beside.ThrowFailure();
    return { NotWanted };
  }
  const double seconds = ChargeProcessorTime(
    used, SecondsSince(start), remaining <= own && HasUsedUpItsTime(process.get()));
  Ending ending = Describe(process.get(), limits);
  ending.ProcessorSeconds = seconds;
  return ending;
}

void BeginProgram(
  int argc, char* argv[], const std::string& stem, const std::function<bool(std::istream&)>& resume)
{
#ifdef SIGXFSZ // of systems that limit the size of files
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  ThisRun.Command.assign(argv, argv + argc);
  ThisRun.Command[0] = vtksys::SystemTools::FindProgram(argv[0]);
  ThisRun.Stem = stem;
  const int own = argc - NumberOfChildArguments;
  if (own > 0 && ThisRun.Command[own] == ChildOption)
  {
    ThisRun.Stem = argv[own + 1];
    ThisRun.Depth = std::atoi(argv[own + 2]);
    ThisRun.ProcessorSeconds = std::atof(argv[own + 3]);
    ThisRun.Command.resize(own);
    RunChild(resume);
  }
}

std::string NameOfSharedFile(const std::string& name)
{
  return ThisRun.Stem + "." + name;
}

bool IsChildProcess()
{
  return ThisRun.Depth > 0;
}

bool ChildProcessesEndWithThis()
{
  return false;
}

/** There is no portable way to limit memory. */
void LimitMemory(double)
{
}

} // namespace carving::helper
