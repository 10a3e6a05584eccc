// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * carve: the command-line program around vtkTopologyCarver and vtkContourCarver.
 */
#include "ErrorLog.h"
#include "Help.h"
#include "LevelWriter.h"
#include "MeshReader.h"
#include "Options.h"
#include "ProfileFile.h"
#include "StreamFile.h"
#include "XmlFile.h"

#include "vtkCallbackCommand.h"
#include "vtkCarverProperty.h"
#include "vtkContourCarver.h"
#include "vtkEnclosingDecimation.h"
#include "vtkFieldData.h"
#include "vtkLogger.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTopologyCarver.h"
#include "vtkUnstructuredGrid.h"

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

/** Overwrites one line of the terminal. */
void ShowProgress(vtkObject* caller, unsigned long, void*, void*)
{
  auto* filter = static_cast<vtkAlgorithm*>(caller);
  const char* stage = filter->GetProgressText();
  std::fprintf(stderr, "\r%3.0f %% %-60s", 100.0 * filter->GetProgress(), stage ? stage : "");
}

void EraseProgress()
{
  if (isatty(STDERR_FILENO))
  {
    std::fprintf(stderr, "\r%66s\r", "");
  }
}

/** A number in the field data of a level; a dash if the number is unknown. */
std::string GetNumber(vtkPolyData* level, const char* name)
{
  const double number = level->GetFieldData()->GetArray(name)->GetTuple1(0);
  return number < 0.0 ? "-" : std::to_string(static_cast<long long>(number));
}

void PrintTable(vtkMultiBlockDataSet* levels, bool contours)
{
  std::printf("%5s %9s %10s %10s %10s %7s %6s\n", "level", "step", "vertices",
    contours ? "edges" : "triangles", "components", contours ? "holes" : "tunnels", "voids");
  for (unsigned int i = 0; i < levels->GetNumberOfBlocks(); ++i)
  {
    auto* level = vtkPolyData::SafeDownCast(levels->GetBlock(i));
    std::printf("%5u %9s %10s %10s %10s %7s %6s\n", i, GetNumber(level, "Step").c_str(),
      GetNumber(level, "Vertices").c_str(), GetNumber(level, "Triangles").c_str(),
      GetNumber(level, "Components").c_str(), GetNumber(level, "Tunnels").c_str(),
      GetNumber(level, "Voids").c_str());
  }
}

void PrintSurfaces(vtkMultiBlockDataSet* surfaces)
{
  std::printf("%5s %10s %10s %12s\n", "level", "vertices", "triangles", "error");
  for (unsigned int i = 0; i < surfaces->GetNumberOfBlocks(); ++i)
  {
    auto* surface = vtkPolyData::SafeDownCast(surfaces->GetBlock(i));
    std::printf("%5u %10s %10s %12g\n", i, GetNumber(surface, "Vertices").c_str(),
      GetNumber(surface, "Triangles").c_str(),
      surface->GetFieldData()->GetArray("Error")->GetTuple1(0));
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

/**
 * Prints the levels, and writes the files that the options ask for. `seconds` is the line of
 * timings so far.
 */
int Finish(const Options& options, ErrorLog* log, vtkMultiBlockDataSet* levels, vtkTable* profile,
  const std::string& seconds)
{
  if (!log->Errors.empty())
  {
    return Fail(log->Errors.front());
  }
  for (const std::string& warning : log->Warnings)
  {
    std::cerr << "carve: warning: " << warning << "\n";
  }
  if (options.Decimate)
  {
    PrintSurfaces(levels);
  }
  else
  {
    PrintTable(levels, options.Contours);
  }
  PrintNotes(levels);
  Clock clock;
  std::vector<std::string> written, warnings;
  if (!options.Output.empty())
  {
    const std::string error = LevelWriter::Write(options.Output, levels, log, written, warnings);
    if (!error.empty())
    {
      return Fail(error);
    }
  }
  if (!options.Profile.empty())
  {
    const std::string error = ProfileFile::Write(options.Profile, profile, options.Contours);
    if (!error.empty())
    {
      return Fail(error);
    }
    written.push_back(options.Profile);
  }
  std::printf("seconds: %s", seconds.c_str());
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

std::string Describe(const char* what, double seconds)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%s %.3f", what, seconds);
  return text;
}

void SetProperties(const Options& options, vtkCarverAlgorithm* carver)
{
  for (const vtkCarverProperty& property : vtkCarverProperty::GetAll())
  {
    const auto given = options.Properties.find(property.Name);
    if (given != options.Properties.end())
    {
      property.Set(carver, given->second);
    }
  }
  carver->SetLevelTargetType(options.TargetType);
  for (const double target : options.Targets)
  {
    carver->AddLevelTarget(target);
  }
}

/** Reads a mesh and prints its size. Returns an empty string, or an error. */
std::string ReadInput(const std::string& fileName, bool contours, ErrorLog* log, vtkPolyData* mesh)
{
  const std::string unreadable =
    ReadMesh(fileName, contours ? Wanted::Contours : Wanted::Polygons, log, mesh);
  if (!unreadable.empty())
  {
    return "cannot read " + fileName + ": " + unreadable;
  }
  std::printf("%s: %lld points, %lld cells\n", fileName.c_str(),
    static_cast<long long>(mesh->GetNumberOfPoints()),
    static_cast<long long>(mesh->GetNumberOfCells()));
  return {};
}

void ShowProgressOf(vtkAlgorithm* filter)
{
  if (isatty(STDERR_FILENO))
  {
    vtkNew<vtkCallbackCommand> progress;
    progress->SetCallback(ShowProgress);
    filter->AddObserver(vtkCommand::ProgressEvent, progress);
  }
}

int DecimateSurface(const Options& options, ErrorLog* log)
{
  Clock clock;
  vtkNew<vtkPolyData> surface;
  const std::string error = ReadInput(options.Input, false, log, surface);
  if (!error.empty())
  {
    return Fail(error);
  }
  const std::string seconds = Describe("read", clock.Lap());
  vtkNew<vtkEnclosingDecimation> decimation;
  decimation->SetInputData(surface);
  decimation->SetNested(options.Nested);
  decimation->SetTargetType(options.TargetType == vtkTopologyCarver::TRIANGLES
      ? vtkEnclosingDecimation::TRIANGLES
      : options.TargetType == vtkTopologyCarver::ERROR_BOUND ? vtkEnclosingDecimation::ERROR_BOUND
                                                             : vtkEnclosingDecimation::VERTICES);
  if (!options.Targets.empty())
  {
    decimation->ClearTargets();
  }
  for (const double target : options.Targets)
  {
    decimation->AddTarget(target);
  }
  ShowProgressOf(decimation);
  decimation->Update();
  EraseProgress();
  return Finish(options, log,
    vtkMultiBlockDataSet::SafeDownCast(decimation->GetOutputDataObject(1)), nullptr,
    seconds + ", " + Describe("decimate", clock.Lap()));
}

int CarveMesh(const Options& options, ErrorLog* log)
{
  Clock clock;
  vtkSmartPointer<vtkCarverAlgorithm> carver = vtkSmartPointer<vtkTopologyCarver>::New();
  if (options.Contours)
  {
    carver = vtkSmartPointer<vtkContourCarver>::New();
  }
  vtkNew<vtkPolyData> mesh, initial;
  for (const auto& [name, data] :
    { std::pair(options.Input, mesh.Get()), std::pair(options.InitialMesh, initial.Get()) })
  {
    const std::string error = name.empty() ? "" : ReadInput(name, options.Contours, log, data);
    if (!error.empty())
    {
      return Fail(error);
    }
  }
  std::string seconds = Describe("read", clock.Lap());
  carver->SetInputData(0, mesh);
  carver->SetInputData(1, initial);
  SetProperties(options, carver);
  ShowProgressOf(carver);
  carver->Update();
  EraseProgress();
  for (int stage = 0; stage < carver->GetNumberOfStages(); ++stage)
  {
    seconds += ", " + Describe(carver->GetStageName(stage), carver->GetStageSeconds(stage));
  }
  if (log->Errors.empty() && !options.Stream.empty())
  {
    clock.Lap();
    if (!XmlFile::Write(options.Stream, carver->GetOutputDataObject(1)))
    {
      return Fail("cannot write " + options.Stream);
    }
    seconds += ", " + Describe("write stream", clock.Lap());
  }
  return Finish(options, log, carver->GetOutput(),
    vtkTable::SafeDownCast(carver->GetOutputDataObject(2)), seconds);
}

int AnswerFromStream(const Options& options, ErrorLog* log)
{
  Clock clock;
  vtkNew<vtkUnstructuredGrid> stream;
  const std::string unreadable = StreamFile::Read(options.Input, log, stream);
  if (!unreadable.empty())
  {
    return Fail("cannot read " + options.Input + ": " + unreadable);
  }
  const std::string read = Describe("read", clock.Lap());
  std::printf("%s: %lld points, %lld cells\n", options.Input.c_str(),
    static_cast<long long>(stream->GetNumberOfPoints()),
    static_cast<long long>(stream->GetNumberOfCells()));
  vtkNew<vtkMultiBlockDataSet> levels;
  vtkNew<vtkTable> profile;
  StreamFile::Extract(options, stream, levels, profile);
  return Finish(options, log, levels, profile, read + ", " + Describe("extract", clock.Lap()));
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
      std::fputs(GetHelp().c_str(), stdout);
      return Success;
    case Options::Action::ShowVersion:
      std::puts("carve " CARVE_VERSION);
      return Success;
    case Options::Action::Carve:
      break;
  }
  const std::string unwritable = options.Profile.empty() ? "" : ProfileFile::Check(options.Profile);
  if (!unwritable.empty())
  {
    return Fail(unwritable);
  }
  // The log collects all messages of VTK.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<ErrorLog> log;
  vtkOutputWindow::SetInstance(log);
  return IsStream(options.Input) ? AnswerFromStream(options, log)
    : options.Decimate           ? DecimateSurface(options, log)
                                 : CarveMesh(options, log);
}
