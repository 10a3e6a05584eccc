// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * carve: the command-line program around vtkTopologyCarver.
 */
#include "ErrorLog.h"
#include "LevelWriter.h"
#include "MeshReader.h"
#include "Options.h"

#include "vtkCallbackCommand.h"
#include "vtkFieldData.h"
#include "vtkLogger.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTopologyCarver.h"

#include <chrono>
#include <cstdio>
#include <iostream>
#include <unistd.h>

namespace
{

constexpr int Success = 0;
constexpr int Failure = 1;
constexpr int WrongUsage = 2;

int Fail(const std::string& error, int exitCode = Failure)
{
  std::cerr << "carve: " << error << "\n";
  return exitCode;
}

class Clock
{
public:
  /** Seconds since the last call. */
  double Lap()
  {
    const auto last = this->Last;
    this->Last = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(this->Last - last).count();
  }

private:
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
};

/** One line on a terminal that is written over and over; nothing elsewhere. */
void ShowProgress(vtkObject* caller, unsigned long, void*, void*)
{
  auto* carver = static_cast<vtkTopologyCarver*>(caller);
  const char* stage = carver->GetProgressText();
  std::fprintf(stderr, "\r%3.0f %% %-16s", 100.0 * carver->GetProgress(), stage ? stage : "");
}

void EraseProgress()
{
  if (isatty(STDERR_FILENO))
  {
    std::fprintf(stderr, "\r%22s\r", "");
  }
}

void PrintTable(vtkMultiBlockDataSet* levels)
{
  std::printf("%5s %9s %10s %10s\n", "level", "step", "vertices", "triangles");
  for (unsigned int i = 0; i < levels->GetNumberOfBlocks(); ++i)
  {
    auto* level = vtkPolyData::SafeDownCast(levels->GetBlock(i));
    vtkDataArray* step = level->GetFieldData()->GetArray("Step");
    std::printf("%5u %9.0f %10lld %10lld\n", i, step->GetTuple1(0),
      static_cast<long long>(level->GetNumberOfPoints()),
      static_cast<long long>(level->GetNumberOfPolys()));
  }
}

void PrintNotes(vtkMultiBlockDataSet* levels)
{
  auto* notes = vtkStringArray::SafeDownCast(levels->GetFieldData()->GetAbstractArray("Notes"));
  for (vtkIdType i = 0; notes && i < notes->GetNumberOfValues(); ++i)
  {
    std::printf("note: %s\n", notes->GetValue(i).c_str());
  }
}

int Run(const Options& options, ErrorLog* log)
{
  Clock clock;
  vtkNew<vtkPolyData> mesh;
  const std::string unreadable = ReadMesh(options.Input, log, mesh);
  if (!unreadable.empty())
  {
    return Fail("cannot read " + options.Input + ": " + unreadable);
  }
  const double readSeconds = clock.Lap();
  std::printf("%s: %lld points, %lld cells\n", options.Input.c_str(),
    static_cast<long long>(mesh->GetNumberOfPoints()),
    static_cast<long long>(mesh->GetNumberOfCells()));

  vtkNew<vtkTopologyCarver> carver;
  carver->SetInputData(mesh);
  carver->SetInitialApproximation(options.InitialApproximation);
  carver->SetPriorityMeasure(options.PriorityMeasure);
  carver->SetDepthExponent(options.DepthExponent);
  carver->SetDepthMeasure(options.DepthMeasure);
  carver->SetBreadthRadius(options.BreadthRadius);
  carver->SetCarveExposed(options.CarveExposed);
  carver->SetCarveVoids(options.CarveVoids);
  carver->SetSolidRule(options.SolidRule);
  carver->SetNumberOfLevels(options.NumberOfLevels);
  carver->SetLevelTargetType(
    options.TargetsAreTriangles ? vtkTopologyCarver::TRIANGLES : vtkTopologyCarver::VERTICES);
  for (const double target : options.Targets)
  {
    carver->AddLevelTarget(target);
  }
  if (isatty(STDERR_FILENO))
  {
    vtkNew<vtkCallbackCommand> progress;
    progress->SetCallback(ShowProgress);
    carver->AddObserver(vtkCommand::ProgressEvent, progress);
  }
  carver->Update();
  EraseProgress();
  if (!log->Errors.empty())
  {
    return Fail(log->Errors.front());
  }
  for (const std::string& warning : log->Warnings)
  {
    std::cerr << "carve: warning: " << warning << "\n";
  }

  vtkMultiBlockDataSet* levels = carver->GetOutput();
  PrintTable(levels);
  PrintNotes(levels);
  clock.Lap();
  std::vector<std::string> written, warnings;
  if (!options.Output.empty())
  {
    const std::string error = LevelWriter::Write(options.Output, levels, log, written, warnings);
    if (!error.empty())
    {
      return Fail(error);
    }
  }
  std::printf("seconds: read %.3f", readSeconds);
  for (int stage = 0; stage < carver->GetNumberOfStages(); ++stage)
  {
    std::printf(", %s %.3f", carver->GetStageName(stage), carver->GetStageSeconds(stage));
  }
  if (!written.empty())
  {
    std::printf(", write %.3f", clock.Lap());
  }
  std::printf("\n");
  for (const std::string& name : written)
  {
    std::printf("wrote %s\n", name.c_str());
  }
  for (const std::string& warning : warnings)
  {
    std::cerr << "carve: warning: " << warning << "\n";
  }
  return Success;
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  const std::string mistake = Parse(argc, argv, options);
  if (!mistake.empty())
  {
    return Fail(mistake + " (see carve --help)", WrongUsage);
  }
  switch (options.Wanted)
  {
    case Options::Action::ShowHelp:
      std::fputs(HelpText, stdout);
      return Success;
    case Options::Action::ShowVersion:
      std::puts("carve " CARVE_VERSION);
      return Success;
    case Options::Action::Carve:
      break;
  }
  // All that VTK reports comes through the log, one line each.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<ErrorLog> log;
  vtkOutputWindow::SetInstance(log);
  return Run(options, log);
}
