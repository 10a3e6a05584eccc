// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * carve: the command-line program around vtkTopologyCarver and vtkContourCarver.
 */
#include "ErrorLog.h"
#include "ExitCode.h"
#include "Help.h"
#include "InputReader.h"
#include "Objects.h"
#include "OptionChecks.h"
#include "Options.h"
#include "ProfileFile.h"
#include "Report.h"
#include "StreamFile.h"
#include "XmlFile.h"

#include "vtkCallbackCommand.h"
#include "vtkCarverProperty.h"
#include "vtkContourCarver.h"
#include "vtkEnclosingDecimation.h"
#include "vtkLogger.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTopologyCarver.h"
#include "vtkUnstructuredGrid.h"
#include "vtksys/SystemTools.hxx"

#include <cstdio>
#include <unistd.h>

using ExitCode::Fail;

namespace
{

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

/** Prints the size of an input, which is a data set or a tree of data sets. */
void PrintSize(const Options& options, const std::string& name, vtkDataObject* input)
{
  if (!options.IsQuiet())
  {
    std::printf("%s: %lld points, %lld cells\n", name.c_str(),
      static_cast<long long>(input->GetNumberOfElements(vtkDataObject::POINT)),
      static_cast<long long>(input->GetNumberOfElements(vtkDataObject::CELL)));
  }
}

/** Reads an input and prints its size. Returns an empty string, or an error. */
std::string Read(const Options& options, const std::string& fileName, ErrorLog* log,
  vtkSmartPointer<vtkDataObject>& input)
{
  const std::string unreadable =
    ReadInput(fileName, options.Contours ? Wanted::Contours : Wanted::Polygons, log, input);
  if (!unreadable.empty())
  {
    return "cannot read " + fileName + ": " + unreadable;
  }
  PrintSize(options, fileName, input);
  return input->IsA("vtkPolyData") ? "" : CheckSeveralMeshes(options, fileName);
}

/** Reads all inputs; several become the blocks of a scene. Returns an empty string, or an error. */
std::string ReadInputs(const Options& options, ErrorLog* log, vtkSmartPointer<vtkDataObject>& input)
{
  vtkNew<vtkMultiBlockDataSet> scene;
  for (const std::string& name : options.Inputs)
  {
    const std::string error = Read(options, name, log, input);
    if (!error.empty())
    {
      return error;
    }
    AddBlock(scene, vtksys::SystemTools::GetFilenameName(name), input);
  }
  if (options.Inputs.size() > 1)
  {
    input = scene;
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
  Report report;
  vtkSmartPointer<vtkDataObject> surface;
  const std::string error = Read(options, options.Inputs[0], log, surface);
  if (!error.empty())
  {
    return Fail(error);
  }
  report.Clock.Record("read");
  vtkNew<vtkEnclosingDecimation> decimation;
  decimation->SetInputDataObject(surface);
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
  report.Clock.Record("decimate");
  report.Levels = vtkMultiBlockDataSet::SafeDownCast(decimation->GetOutputDataObject(1));
  return Finish(options, log, report);
}

/** Reads the mesh to start from, if there is one. Returns an empty string, or an error. */
std::string ReadInitialMesh(const Options& options, ErrorLog* log, vtkCarverAlgorithm* carver)
{
  if (options.InitialMesh.empty())
  {
    return {};
  }
  vtkSmartPointer<vtkDataObject> initial;
  const std::string error = Read(options, options.InitialMesh, log, initial);
  if (error.empty() && !initial->IsA("vtkPolyData"))
  {
    return "--initial-mesh requires a single mesh, and " + options.InitialMesh + " has several";
  }
  carver->SetInputDataObject(1, initial);
  return error;
}

int CarveMesh(const Options& options, ErrorLog* log)
{
  Report report;
  vtkSmartPointer<vtkCarverAlgorithm> carver = vtkSmartPointer<vtkTopologyCarver>::New();
  if (options.Contours)
  {
    carver = vtkSmartPointer<vtkContourCarver>::New();
  }
  vtkSmartPointer<vtkDataObject> input;
  std::string error = ReadInputs(options, log, input);
  error = error.empty() ? ReadInitialMesh(options, log, carver) : error;
  if (!error.empty())
  {
    return Fail(error);
  }
  report.Clock.Record("read");
  carver->SetInputDataObject(0, input);
  SetProperties(options, carver);
  vtkSMPTools::Initialize(carver->GetNumberOfThreads()); // for VTK's own loops
  carver->ReuseDecompositionOff();
  ShowProgressOf(carver);
  carver->Update();
  EraseProgress();
  for (int stage = 0; stage < carver->GetNumberOfStages(); ++stage)
  {
    report.Clock.Add(carver->GetStageName(stage), carver->GetStageSeconds(stage));
  }
  report.Stream = vtkUnstructuredGrid::SafeDownCast(carver->GetOutputDataObject(1));
  if (log->Errors.empty() && !options.Stream.empty())
  {
    report.Clock.Start();
    if (!XmlFile::Write(options.Stream, carver->GetOutputDataObject(1)))
    {
      return Fail("cannot write " + options.Stream);
    }
    report.Clock.Record("write stream");
  }
  report.Levels = carver->GetOutput();
  report.Profile = vtkTable::SafeDownCast(carver->GetOutputDataObject(2));
  return Finish(options, log, report);
}

int AnswerFromStream(Options options, ErrorLog* log)
{
  Report report;
  vtkNew<vtkUnstructuredGrid> stream;
  const std::string unreadable = StreamFile::Read(options.Inputs[0], log, stream);
  if (!unreadable.empty())
  {
    return Fail("cannot read " + options.Inputs[0] + ": " + unreadable);
  }
  report.Clock.Record("read");
  options.Contours = StreamFile::HoldsContours(stream);
  const std::string misuse = CheckContours(options);
  if (!misuse.empty())
  {
    return Fail(misuse, ExitCode::WrongUsage);
  }
  PrintSize(options, options.Inputs[0], stream);
  report.Levels = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  report.Profile = vtkSmartPointer<vtkTable>::New();
  StreamFile::Extract(options, stream, report.Levels, report.Profile);
  report.Clock.Record("extract");
  return Finish(options, log, report);
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  const std::string mistake = Parse(argc, argv, options);
  if (!mistake.empty())
  {
    return Fail(mistake + " (see carve --help)", ExitCode::WrongUsage);
  }
  switch (options.Wanted)
  {
    case Options::Action::ShowHelp:
      std::fputs(GetHelp().c_str(), stdout);
      return ExitCode::Success;
    case Options::Action::ShowVersion:
      std::puts("carve " CARVE_VERSION);
      return ExitCode::Success;
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
