// SPDX-License-Identifier: BSD-3-Clause
#include "Process/HelperProcess.h"

#include "Process/MemoryFile.h"
#include "vtkResourceFileLocator.h"
#include "vtksys/Process.h"
#include "vtksys/SystemTools.hxx"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

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
  const std::string directory = vtksys::SystemTools::GetFilenamePath(library);
  const std::string candidates[] = { directory + "/" + HelperName,
    directory + "/" TOPOLOGYCARVING_HELPER_DIRECTORY "/" + HelperName };
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
  Listener(const HelperProcess::Observer& observer)
    : Observe(observer)
  {
  }

  bool Hear(const char* data, int length)
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
        goOn = goOn && this->Report();
      }
      else
      {
        this->Keep();
      }
      this->Line.clear();
    }
    return goOn;
  }

  bool Report() const
  {
    return !this->Observe || this->Observe(this->Progress);
  }

  /** The end of an error message: the stage of the work, and the last words of the program. */
  std::string LastWords()
  {
    this->Keep();
    std::string words =
      std::string(" in the stage: ") + carving::StageName(this->Progress.Stage) + ".";
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

  const HelperProcess::Observer& Observe;
  carving::WorkProgress Progress;
  std::string Line;
  std::string Words;
};

/**
 * Waits for the end of the process. Returns false, after killing the process, if the observer wants
 * to stop.
 */
bool Listen(vtksysProcess* process, Listener& listener)
{
  for (;;)
  {
    constexpr double pollInterval = 0.1;
    double timeout = pollInterval;
    char* data = nullptr;
    int length = 0;
    const int pipe = vtksysProcess_WaitForData(process, &data, &length, &timeout);
    if (pipe == vtksysProcess_Pipe_None)
    {
      vtksysProcess_WaitForExit(process, nullptr);
      return true;
    }
    const bool goOn =
      pipe == vtksysProcess_Pipe_STDERR ? listener.Hear(data, length) : listener.Report();
    if (!goOn)
    {
      vtksysProcess_Kill(process);
      vtksysProcess_WaitForExit(process, nullptr);
      return false;
    }
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
std::string WriteJob(const carving::Job& job, const MemoryFile& file)
{
  std::ofstream out(file.GetPath(), std::ios::binary);
  carving::Write(out, job);
  out.close();
  return out ? "" : "There is not enough memory to hand the mesh to the helper program.";
}

/** Reads the reply. Returns an empty string, or an error. */
std::string ReadReply(const MemoryFile& file, const std::string& program, carving::Reply& reply)
{
  std::string error;
  file.Read([&](const char* data, std::size_t size) { error = carving::Read(data, size, reply); });
  return error.empty() ? reply.Error
                       : "The reply of " + program + " cannot be used: " + error +
      ". Make sure that it was built together with this library.";
}

/** Runs the program until it ends, or until the observer wants to stop. */
HelperProcess::Outcome Execute(const std::string& program, const MemoryFile& job,
  const MemoryFile& reply, const HelperProcess::Observer& observer, std::string& error)
{
  const std::unique_ptr<vtksysProcess, void (*)(vtksysProcess*)> process(
    vtksysProcess_New(), vtksysProcess_Delete);
  const char* command[] = { program.c_str(), nullptr };
  vtksysProcess_SetCommand(process.get(), command);
  vtksysProcess_SetPipeFile(process.get(), vtksysProcess_Pipe_STDIN, job.GetPath().c_str());
  vtksysProcess_SetPipeFile(process.get(), vtksysProcess_Pipe_STDOUT, reply.GetPath().c_str());
  vtksysProcess_Execute(process.get());
  Listener listener(observer);
  if (!Listen(process.get(), listener))
  {
    return HelperProcess::Outcome::Aborted;
  }
  error = DescribeEnd(process.get(), listener);
  return error.empty() ? HelperProcess::Outcome::Success : HelperProcess::Outcome::Failure;
}

} // namespace

HelperProcess::Outcome HelperProcess::Run(
  const carving::Job& job, carving::Reply& reply, const Observer& observer, std::string& error)
{
  const std::string program = FindHelper(error);
  if (program.empty())
  {
    return Outcome::Failure;
  }
  const MemoryFile jobFile("carving-job");
  const MemoryFile replyFile("carving-reply");
  error = jobFile.IsOpen() && replyFile.IsOpen()
    ? WriteJob(job, jobFile)
    : std::string("No file in memory could be opened: ") + std::strerror(errno);
  if (!error.empty())
  {
    return Outcome::Failure;
  }
  const Outcome outcome = Execute(program, jobFile, replyFile, observer, error);
  if (outcome != Outcome::Success)
  {
    return outcome;
  }
  error = ReadReply(replyFile, program, reply);
  return error.empty() ? Outcome::Success : Outcome::Failure;
}
