// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "ErrorLog.h"
#include "ExitCode.h"
#include "JsonFile.h"
#include "LevelTable.h"
#include "LevelWriter.h"
#include "Objects.h"
#include "Options.h"
#include "ProfileFile.h"

#include "vtksys/SystemTools.hxx"

#include <cstdio>
#include <future>
#include <utility>

namespace
{

/** Writes the levels of every input to a file in a folder. Returns an empty string, or an error. */
std::string WriteFolder(const Options& options, ErrorLog* log, Report& report)
{
  if (!vtksys::SystemTools::MakeDirectory(options.Output))
  {
    return "cannot make the folder " + options.Output;
  }
  for (std::size_t i = 0; i < options.Inputs.size(); ++i)
  {
    auto* levels = vtkMultiBlockDataSet::SafeDownCast(options.Inputs.size() == 1
        ? report.Levels.Get()
        : report.Levels->GetBlock(static_cast<unsigned>(i)));
    if (levels->GetNumberOfBlocks() == 0)
    {
      continue; // an error has said why
    }
    const std::string error = LevelWriter::Write(
      options.GetFile(options.Inputs[i]), levels, log, report.Files, report.Warnings);
    if (!error.empty())
    {
      return error;
    }
  }
  return {};
}

/** Writes all files but the JSON. Returns an empty string, or an error. */
std::string WriteFiles(const Options& options, ErrorLog* log, Report& report)
{
  report.Clock.Start();
  // A table takes as long as the levels, and is written beside them. A chart stays in the main
  // thread.
  std::future<std::string> profile;
  if (!options.Profile.empty())
  {
    const auto anywhere = std::launch::async | std::launch::deferred;
    profile = std::async(ProfileFile::IsChart(options.Profile) ? std::launch::deferred : anywhere,
      [&] { return ProfileFile::Write(options.Profile, report.Profile, options.Contours); });
  }
  std::string error = options.Output.empty() ? ""
    : options.WritesFolder()
    ? WriteFolder(options, log, report)
    : LevelWriter::Write(options.Output, report.Levels, log, report.Files, report.Warnings);
  if (profile.valid())
  {
    const std::string profileError = profile.get();
    error = error.empty() ? profileError : error;
    report.Files.push_back(options.Profile);
  }
  if (!report.Files.empty())
  {
    report.Clock.Record("write");
  }
  return error;
}

void Print(const Report& report)
{
  const char* separator = "seconds: ";
  for (const auto& [stage, seconds] : report.Clock.GetSeconds())
  {
    std::printf("%s%s %.3f", separator, stage.c_str(), seconds);
    separator = ", ";
  }
  std::printf("\n");
  for (const std::string& name : report.Files)
  {
    std::printf("wrote %s\n", name.c_str());
  }
}

} // namespace

int Finish(const Options& options, ErrorLog* log, Report& report)
{
  report.Errors = log->Errors;
  report.Warnings = std::exchange(log->Warnings, {});
  if (!report.Errors.empty() && ListObjects(options.Inputs, report.Levels).size() == 1)
  {
    return ExitCode::Fail(report.Errors.front());
  }
  for (const std::string& error : report.Errors) // the other meshes have levels
  {
    ExitCode::Fail(error);
  }
  const std::string unwritten = WriteFiles(options, log, report);
  report.Warnings.insert(report.Warnings.end(), log->Warnings.begin(), log->Warnings.end());
  if (!options.IsQuiet())
  {
    LevelTable::Print(options, report.Levels);
    if (report.Stream)
    {
      LevelTable::PrintStream(report.Stream, options.Contours);
    }
  }
  for (const std::string& warning : report.Warnings)
  {
    std::cerr << "carve: warning: " << warning << "\n";
  }
  if (!unwritten.empty())
  {
    return ExitCode::Fail(unwritten);
  }
  if (!options.IsQuiet())
  {
    Print(report);
  }
  if (!options.Json.empty() && !JsonFile::Write(options, report))
  {
    return ExitCode::Fail("cannot write " + options.Json);
  }
  if (std::fflush(stdout) != 0)
  {
    return ExitCode::Fail("cannot write to standard output");
  }
  return report.Errors.empty() ? ExitCode::Success : ExitCode::Failure;
}
