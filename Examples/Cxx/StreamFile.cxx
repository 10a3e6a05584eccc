// SPDX-License-Identifier: BSD-3-Clause
#include "StreamFile.h"

#include "ErrorLog.h"
#include "Options.h"

#include "vtkCellType.h"
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

double GetStep(vtkPolyData* level)
{
  vtkDataArray* step = level->GetFieldData()->GetArray("Step");
  return step ? step->GetTuple1(0) : -1.0;
}

/** Adds a copy of a level, unless it is empty: then the filter has reported an error. */
void AddLevel(vtkPolyData* level, std::vector<vtkSmartPointer<vtkPolyData>>& levels)
{
  if (level->GetNumberOfCells() > 0)
  {
    levels.push_back(vtkSmartPointer<vtkPolyData>::New());
    levels.back()->ShallowCopy(level);
    levels.back()->GetInformation()->Remove(vtkDataObject::DATA_TIME_STEP()); // would be written
  }
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
  // The reader reports no error for some damaged files.
  if (reader->GetOutput()->GetNumberOfCells() == 0)
  {
    return "there are no cells in it";
  }
  stream->ShallowCopy(reader->GetOutput());
  return {};
}

bool StreamFile::HoldsContours(vtkUnstructuredGrid* stream)
{
  const vtkIdType cells = stream->GetNumberOfCells(); // those of the input come last
  return cells > 0 && stream->GetCellType(cells - 1) == VTK_LINE;
}

void StreamFile::Extract(const Options& options, vtkUnstructuredGrid* stream,
  vtkMultiBlockDataSet* levels, vtkTable* profile)
{
  vtkNew<vtkExtractCarvedLOD> extract;
  extract->SetInputData(stream);
  extract->SetManifoldOutput(options.ManifoldOutput);
  if (options.Simplifies())
  {
    extract->SetLevelSimplification(vtkExtractCarvedLOD::ENCLOSING_COLLAPSE);
    const auto most = options.Properties.find("MaximumVertices");
    extract->SetMaximumVertices(
      most != options.Properties.end() ? static_cast<int>(most->second) : 0);
  }
  std::vector<vtkSmartPointer<vtkPolyData>> found;
  if (options.Targets.empty())
  {
    // Times stand for levels that are spread like the carver's. A single level is the last one.
    const int count = std::max(options.NumberOfLevels, 2);
    extract->SetNumberOfTimeSteps(count);
    for (int time = options.NumberOfLevels > 1 ? 0 : 1; time < count; ++time)
    {
      extract->UpdateTimeStep(time);
      AddLevel(extract->GetOutput(), found);
    }
    // Several times stand for the same step where a stream has few steps.
    found.erase(std::unique(found.begin(), found.end(),
                  [](const auto& a, const auto& b) { return GetStep(a) == GetStep(b); }),
      found.end());
  }
  else
  {
    extract->SetLevelTargetType(options.TargetType);
    std::vector<double> targets = options.Targets;
    std::sort(targets.begin(), targets.end());
    if (options.TargetType == vtkExtractCarvedLOD::ERROR_BOUND ||
      options.TargetType == vtkExtractCarvedLOD::FEATURE_SIZE)
    {
      std::reverse(targets.begin(), targets.end()); // from coarse to fine
    }
    for (const double target : targets)
    {
      extract->SetLevelTarget(target);
      extract->Update();
      AddLevel(extract->GetOutput(), found);
    }
  }
  levels->SetNumberOfBlocks(static_cast<unsigned int>(found.size()));
  for (unsigned int i = 0; i < found.size(); ++i)
  {
    levels->SetBlock(i, found[i]);
    levels->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), ("LOD " + std::to_string(i)).c_str());
  }
  extract->GetProfile(profile);
}
