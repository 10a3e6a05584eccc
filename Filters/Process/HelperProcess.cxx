// SPDX-License-Identifier: BSD-3-Clause
#include "Process/HelperProcess.h"

#include "Process/HelperCommand.h"
#include "vtkResourceFileLocator.h"
#include "vtksys/SystemTools.hxx"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>

// A symbol by which the dynamic linker finds this library.
extern "C" VTKTOPOLOGYCARVING_EXPORT void TopologyCarvingLibraryAnchor()
{
}

namespace
{

constexpr const char* HelperVariable = "TOPOLOGYCARVING_HELPER";
constexpr const char* HelperName = "carving-helper";

bool IsProgram(const std::string& path)
{
  return vtksys::SystemTools::FileExists(path, true) &&
    vtksys::SystemTools::TestFileAccess(path, vtksys::TEST_FILE_EXECUTE);
}

/**
 * The path of the helper program; empty if there is none. Then `error` lists the places that were
 * searched.
 */
std::string FindHelper(std::string& error)
{
  std::string named;
  if (vtksys::SystemTools::GetEnv(HelperVariable, named) && !named.empty())
  {
    if (!IsProgram(named))
    {
      error = std::string("The environment variable ") + HelperVariable + " names \"" + named +
        "\", which is not an executable file. Correct or unset it.";
      return {};
    }
    return named;
  }
  const std::string library = vtkGetLibraryPathForSymbol(TopologyCarvingLibraryAnchor);
  // The library may be found through a link to its folder, as /lib is one on Debian. Paths that go
  // up from there would go wrong.
  const std::string directory =
    vtksys::SystemTools::GetRealPath(vtksys::SystemTools::GetFilenamePath(library));
  const std::string name = std::string(HelperName) + vtksys::SystemTools::GetExecutableExtension();
  const std::string candidates[] = { directory + "/" + name,
    directory + "/" TOPOLOGYCARVING_HELPER_DIRECTORY "/" + name };
  error =
    std::string("The helper program ") + HelperName + " was not found. The searched paths are";
  for (const std::string& candidate : candidates)
  {
    if (IsProgram(candidate))
    {
      return vtksys::SystemTools::CollapseFullPath(candidate);
    }
    error += " " + vtksys::SystemTools::CollapseFullPath(candidate);
  }
  error += std::string(". Install it there, or set the environment variable ") + HelperVariable +
    " to its full path.";
  return {};
}

/**
 * Splits the lines that the helper program writes to standard error into progress and words for the
 * user.
 */
class Listener
{
public:
  /** Returns false if the observer wants to stop. */
  bool Hear(const char* data, int length, const HelperProcess::Observer& observer)
  {
    bool goOn = true;
    for (int i = 0; i < length; ++i)
    {
      if (data[i] != '\n')
      {
        this->Line += data[i];
        continue;
      }
      if (carving::ParseProgress(this->Line, this->Progress))
      {
        goOn = goOn && this->Report(observer);
      }
      else
      {
        this->Keep();
      }
      this->Line.clear();
    }
    return goOn;
  }

  bool Report(const HelperProcess::Observer& observer) const
  {
    return !observer || observer(this->Progress);
  }

  /** Decimations have no stages. */
  void LeaveOutStages()
  {
    this->HasStages = false;
  }

  /** The end of an error message: the stage of the work, and the last words of the program. */
  std::string LastWords()
  {
    this->Keep();
    std::string words = this->HasStages
      ? std::string(" in the stage: ") + carving::StageName(this->Progress.Stage) + "."
      : ".";
    if (!this->Words.empty())
    {
      words += " Its last output: " + this->Words;
    }
    return words;
  }

private:
  void Keep()
  {
    constexpr std::size_t maximumLength = 1000;
    if (!this->Line.empty())
    {
      this->Words += (this->Words.empty() ? "" : " | ") + this->Line;
    }
    if (this->Words.size() > maximumLength)
    {
      this->Words.erase(0, this->Words.size() - maximumLength);
    }
    this->Line.clear();
  }

  carving::WorkProgress Progress;
  bool HasStages = true;
  std::string Line;
  std::string Words;
};

/** What a process does, or the observer wants. */
enum class Activity
{
  Talks,
  IsSilent,
  HasEnded,
  IsUnwanted
};

/** Hears the next output of the process, for at most `timeout` seconds. */
Activity HearNext(vtksysProcess* process, double timeout, Listener& listener,
  const HelperProcess::Observer& observer)
{
  char* data = nullptr;
  int length = 0;
  switch (vtksysProcess_WaitForData(process, &data, &length, &timeout))
  {
    case vtksysProcess_Pipe_None:
      vtksysProcess_WaitForExit(process, nullptr);
      return Activity::HasEnded;
    case vtksysProcess_Pipe_STDERR:
    case vtksysProcess_Pipe_STDOUT: // words of TetGen, unless standard output is the reply
      return listener.Hear(data, length, observer) ? Activity::Talks : Activity::IsUnwanted;
    default:
      return listener.Report(observer) ? Activity::IsSilent : Activity::IsUnwanted;
  }
}

/** The error that ended the process; empty if there was none. */
std::string DescribeEnd(vtksysProcess* process, Listener& listener)
{
  const std::string name = HelperName;
  switch (vtksysProcess_GetState(process))
  {
    case vtksysProcess_State_Exited:
      return vtksysProcess_GetExitValue(process) == 0 ? ""
                                                      : name + " ended with exit code " +
          std::to_string(vtksysProcess_GetExitValue(process)) + listener.LastWords();
    case vtksysProcess_State_Exception:
      return name + " died (" + vtksysProcess_GetExceptionString(process) + ")" +
        listener.LastWords();
    default:
      return name + " could not be run: " + vtksysProcess_GetErrorString(process);
  }
}

/** Writes the job. Returns an empty string, or an error. */
std::string WriteJob(const carving::Job& job, const TemporaryFile& file)
{
  std::ofstream out(file.GetPath(), std::ios::binary);
  carving::Write(out, job);
  out.close();
  return out ? ""
             : "There is not enough room in " + TemporaryFile::GetPlace() +
      " to hand the mesh to the helper program. Make room, or use a smaller mesh.";
}

/** Reads the reply. Returns an empty string, or an error. */
std::string ReadReply(const TemporaryFile& file, const std::string& program,
  const carving::Sources& sources, int threads, carving::Reply& reply)
{
  std::string error;
  try
  {
    file.Read([&](const char* data, std::size_t size)
      { error = carving::Read(data, size, reply, threads); });
    error = error.empty() ? carving::FindForeignSource(reply, sources) : error;
  }
  catch (const std::bad_alloc&)
  {
    return "There is not enough memory for the reply of " + program +
      ". Use a smaller mesh, or a machine with more memory.";
  }
  return error.empty() ? reply.Error
                       : "The reply of " + program + " cannot be used: " + error +
      ". Make sure that it was built together with this library.";
}

} // namespace

class HelperProcess::Program
{
public:
  explicit Program(const std::string& path)
    : Path(path)
  {
  }
  ~Program()
  {
    vtksysProcess_Kill(this->Process.get());                 // the library would wait for the end
    vtksysProcess_WaitForExit(this->Process.get(), nullptr); // before the files are removed
  }

  /** Returns an empty string, or an error. */
  std::string Start(const carving::Job& job)
  {
    this->Threads = job.Processes;
    if (job.Kind == carving::JobKind::Decimate)
    {
      this->Words.LeaveOutStages();
    }
    this->Sources = carving::CountSources(job);
    const std::string error = this->Job.IsOpen() && this->Reply.IsOpen()
      ? WriteJob(job, this->Job)
      : "No file could be opened in " + TemporaryFile::GetPlace() + ": " + std::strerror(errno);
    if (error.empty())
    {
      SetHelperCommand(this->Process.get(), this->Path, this->Job, this->Reply);
      vtksysProcess_Execute(this->Process.get());
    }
    return error;
  }

  bool IsRunning()
  {
    Activity activity = Activity::Talks;
    while (activity == Activity::Talks)
    {
      activity = HearNext(this->Process.get(), 0.0, this->Words, {});
    }
    return activity != Activity::HasEnded;
  }

  Outcome Wait(const Observer& observer, carving::Reply& reply, std::string& error)
  {
    constexpr double pollInterval = 0.02; // seconds
    Activity activity = Activity::Talks;
    while (activity != Activity::HasEnded)
    {
      activity = HearNext(this->Process.get(), pollInterval, this->Words, observer);
      if (activity == Activity::IsUnwanted)
      {
        return Outcome::Aborted;
      }
    }
    error = DescribeEnd(this->Process.get(), this->Words);
    error = error.empty() ? ReadReply(this->Reply, this->Path, this->Sources, this->Threads, reply)
                          : error;
    return error.empty() ? Outcome::Success : Outcome::Failure;
  }

private:
  const std::string Path;
  int Threads = 1;
  carving::Sources Sources;
  Listener Words;
  const std::unique_ptr<vtksysProcess, void (*)(vtksysProcess*)> Process{ vtksysProcess_New(),
    vtksysProcess_Delete };
  // Opened last, so that errno still has the reason of a failure.
  const TemporaryFile Job{ "carving-job" };
  const TemporaryFile Reply{ "carving-reply" };
};

HelperProcess::HelperProcess() = default;
HelperProcess::~HelperProcess() = default;
HelperProcess::HelperProcess(HelperProcess&&) noexcept = default;
HelperProcess& HelperProcess::operator=(HelperProcess&&) noexcept = default;

std::string HelperProcess::Start(const carving::Job& job)
{
  std::string error;
  const std::string path = FindHelper(error);
  if (path.empty())
  {
    return error;
  }
  this->Running = std::make_unique<Program>(path);
  return this->Running->Start(job);
}

bool HelperProcess::IsRunning()
{
  return this->Running->IsRunning();
}

HelperProcess::Outcome HelperProcess::Wait(
  const Observer& observer, carving::Reply& reply, std::string& error)
{
  return this->Running->Wait(observer, reply, error);
}

HelperProcess::Outcome HelperProcess::Run(
  const carving::Job& job, carving::Reply& reply, const Observer& observer, std::string& error)
{
  HelperProcess process;
  error = process.Start(job);
  return error.empty() ? process.Wait(observer, reply, error) : Outcome::Failure;
}
