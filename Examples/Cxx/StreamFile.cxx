// SPDX-License-Identifier: BSD-3-Clause
#include "StreamFile.h"

#include "Convert/StreamInput.h"
#include "Convert/StreamOutput.h"
#include "Core/Measure/LevelSelection.h"
#include "ErrorLog.h"
#include "Options.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>

namespace
{

/** Steps spread like the carver's levels, from the profile that the stream carries. */
std::vector<double> SpreadSteps(vtkUnstructuredGrid* stream, int count)
{
  carving::Profile profile;
  if (!ReadProfile(stream, profile).empty())
  {
    return { 0.0 }; // the filter says what is wrong
  }
  const std::vector<int> steps = carving::SpreadLevels(profile, count);
  return { steps.begin(), steps.end() };
}

double GetStep(vtkPolyData* level)
{
  vtkDataArray* step = level->GetFieldData()->GetArray("Step");
  return step ? step->GetTuple1(0) : -1.0;
}

} // namespace

std::string StreamFile::Read(
  const std::string& fileName, ErrorLog* log, vtkUnstructuredGrid* stream)
{
  if (!vtksys::SystemTools::FileExists(fileName, true))
  {
    return "there is no such file";
  }
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  if (!log->Errors.empty())
  {
    return log->Errors.front();
  }
  // The reader gives up on some files without an error.
  if (reader->GetOutput()->GetNumberOfCells() == 0)
  {
    return "there are no cells in it";
  }
  stream->ShallowCopy(reader->GetOutput());
  return {};
}

void StreamFile::GetProfile(vtkUnstructuredGrid* stream, vtkTable* profile)
{
  carving::Profile found;
  if (ReadProfile(stream, found).empty())
  {
    FillProfile(found, profile);
  }
}

void StreamFile::Extract(
  const Options& options, vtkUnstructuredGrid* stream, vtkMultiBlockDataSet* levels)
{
  const bool byNumber = options.Targets.empty();
  const std::vector<double> targets =
    byNumber ? SpreadSteps(stream, options.NumberOfLevels) : options.Targets;
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputData(stream);
  extract->SetManifoldOutput(options.ManifoldOutput);
  extract->SetLevelTargetType(byNumber ? vtkExtractCarvedLOD::STEP : options.TargetType);
  std::vector<vtkSmartPointer<vtkPolyData>> found;
  for (const double target : targets)
  {
    extract->SetLevelTarget(target);
    extract->Update();
    auto level = vtkSmartPointer<vtkPolyData>::New();
    level->ShallowCopy(extract->GetOutput());
    if (level->GetNumberOfCells() > 0)
    {
      found.push_back(level);
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [](const auto& a, const auto& b) { return GetStep(a) < GetStep(b); });
  levels->SetNumberOfBlocks(static_cast<unsigned int>(found.size()));
  for (unsigned int i = 0; i < found.size(); ++i)
  {
    levels->SetBlock(i, found[i]);
    levels->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), ("LOD " + std::to_string(i)).c_str());
  }
}
