// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * carve: the command-line program around vtkTopologyCarver and vtkContourCarver.
 */
#include "ErrorLog.h"
#include "Help.h"
#include "LevelTable.h"
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
#include "vtkInformation.h"
#include "vtkLogger.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTopologyCarver.h"
#include "vtkUnstructuredGrid.h"
#include "vtksys/SystemTools.hxx"

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

/** Prints the tables of a scene, one for each input. */
void PrintScene(const Options& options, vtkMultiBlockDataSet* scene)
{
  for (std::size_t i = 0; i < options.Inputs.size(); ++i)
  {
    auto* levels = vtkMultiBlockDataSet::SafeDownCast(scene->GetBlock(static_cast<unsigned>(i)));
    std::printf(
      "%s%s\n", options.Inputs[i].c_str(), levels->GetNumberOfBlocks() == 0 ? ": no levels" : "");
    LevelTable::PrintLevels(levels, options.Contours);
    LevelTable::PrintNotes(levels);
  }
}

void PrintOutput(const Options& options, vtkMultiBlockDataSet* output)
{
  if (options.Decimate)
  {
    LevelTable::PrintSurfaces(output);
  }
  else if (options.IsScene())
  {
    PrintScene(options, output);
  }
  else
  {
    LevelTable::PrintLevels(output, options.Contours);
  }
  LevelTable::PrintNotes(output);
}

/**
 * Prints the levels, and writes the files that the options ask for. `seconds` is the line of
 * timings so far.
 */
int Finish(const Options& options, ErrorLog* log, vtkMultiBlockDataSet* levels, vtkTable* profile,
  const std::string& seconds)
{
  if (!log->Errors.empty() && !options.IsScene())
  {
    return Fail(log->Errors.front());
  }
  for (const std::string& error : log->Errors) // the other inputs have levels
  {
    Fail(error);
  }
  const int exitCode = log->Errors.empty() ? Success : Failure;
  for (const std::string& warning : log->Warnings)
  {
    std::cerr << "carve: warning: " << warning << "\n";
  }
  PrintOutput(options, levels);
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
  return exitCode;
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

/** Reads all inputs as the blocks of a scene. Returns an empty string, or an error. */
std::string ReadScene(const Options& options, ErrorLog* log, vtkMultiBlockDataSet* scene)
{
  for (const std::string& name : options.Inputs)
  {
    vtkNew<vtkPolyData> mesh;
    const std::string error = ReadInput(name, options.Contours, log, mesh);
    if (!error.empty())
    {
      return error;
    }
    const unsigned int block = scene->GetNumberOfBlocks();
    scene->SetBlock(block, mesh);
    scene->GetMetaData(block)->Set(
      vtkCompositeDataSet::NAME(), vtksys::SystemTools::GetFilenameName(name));
  }
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
  const std::string error = ReadInput(options.Inputs[0], false, log, surface);
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
  vtkNew<vtkMultiBlockDataSet> scene;
  vtkNew<vtkPolyData> initial;
  std::string error = ReadScene(options, log, scene);
  if (error.empty() && !options.InitialMesh.empty())
  {
    error = ReadInput(options.InitialMesh, options.Contours, log, initial);
  }
  if (!error.empty())
  {
    return Fail(error);
  }
  std::string seconds = Describe("read", clock.Lap());
  carver->SetInputDataObject(0, options.IsScene() ? scene.Get() : scene->GetBlock(0));
  carver->SetInputData(1, initial);
  SetProperties(options, carver);
  ShowProgressOf(carver);
  carver->Update();
  EraseProgress();
  for (int stage = 0; stage < carver->GetNumberOfStages(); ++stage)
  {
    seconds += ", " + Describe(carver->GetStageName(stage), carver->GetStageSeconds(stage));
  }
  auto* stream = vtkUnstructuredGrid::SafeDownCast(carver->GetOutputDataObject(1));
  if (stream) // a scene has several
  {
    LevelTable::PrintStream(stream, options.Contours);
  }
  if (log->Errors.empty() && !options.Stream.empty())
  {
    clock.Lap();
    if (!XmlFile::Write(options.Stream, stream))
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
  const std::string unreadable = StreamFile::Read(options.Inputs[0], log, stream);
  if (!unreadable.empty())
  {
    return Fail("cannot read " + options.Inputs[0] + ": " + unreadable);
  }
  const std::string read = Describe("read", clock.Lap());
  std::printf("%s: %lld points, %lld cells\n", options.Inputs[0].c_str(),
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
  return IsStream(options.Inputs[0]) ? AnswerFromStream(options, log)
    : options.Decimate               ? DecimateSurface(options, log)
                                     : CarveMesh(options, log);
}
