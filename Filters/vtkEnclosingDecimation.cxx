// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEnclosingDecimation.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayTools.h"
#include "Convert/CarverInput.h"
#include "Convert/CellArrays.h"
#include "Convert/IsSame.h"
#include "Convert/OwnArrays.h"
#include "Convert/PointOutput.h"
#include "Objects/CompositeTree.h"
#include "Session/CarverNotes.h"
#include "Session/CarverStages.h"
#include "Session/RepeatedDecimation.h"
#include "Session/WithinMemory.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkEnclosingDecimation);

namespace
{

static_assert(IsSame(vtkEnclosingDecimation::VERTICES, carving::DecimationTarget::Vertices) &&
  IsSame(vtkEnclosingDecimation::TRIANGLES, carving::DecimationTarget::Triangles) &&
  IsSame(vtkEnclosingDecimation::ERROR_BOUND, carving::DecimationTarget::ErrorBound));

constexpr const char* TargetTypeNames[] = { "VERTICES", "TRIANGLES", "ERROR_BOUND" };

void FillSurface(const carving::Decimation& decimation, const carving::DecimatedSurface& result,
  vtkPolyData* input, vtkPolyData* output)
{
  const carving::CollapsedSurface surface =
    carving::ExtractSurface(decimation.Chain, result.Collapses);
  carving::ResolvedMesh points;
  for (const int point : surface.Points)
  {
    points.Points.push_back(decimation.Points[point]);
    points.PointSources.push_back(decimation.PointSources[point]);
  }
  FillPoints<3>(points, input, output);
  vtkNew<vtkCellArray> triangles;
  FillCellArray(surface.Triangles, triangles);
  output->SetPolys(triangles);
  vtkFieldData* fieldData = output->GetFieldData();
  AddFieldValue<vtkIdTypeArray>(
    fieldData, LevelArrays::Vertices, static_cast<vtkIdType>(points.Points.size()));
  AddFieldValue<vtkIdTypeArray>(fieldData, LevelArrays::NewVertices,
    static_cast<vtkIdType>(std::count(points.PointSources.begin(), points.PointSources.end(), -1)));
  AddFieldValue<vtkIdTypeArray>(
    fieldData, LevelArrays::Triangles, static_cast<vtkIdType>(surface.Triangles.size()));
  AddFieldValue<vtkDoubleArray>(fieldData, LevelArrays::Error, result.Error);
}

/** The input with the point data that the surfaces can have. Adds notes on the rest. */
vtkSmartPointer<vtkPolyData> WithUsablePointData(
  vtkPolyData* input, std::vector<std::string>& notes)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(input);
  copy->GetCellData()->Initialize();
  return WithUsableArrays(copy, notes);
}

carving::Job JobFor(int type, std::vector<double> targets)
{
  carving::Job job;
  job.Kind = carving::JobKind::Decimate;
  job.Processes = vtkSMPTools::GetEstimatedNumberOfThreads();
  job.Decimation.Type = static_cast<carving::DecimationTarget>(type);
  // From the finest to the coarsest.
  std::sort(targets.begin(), targets.end());
  if (job.Decimation.Type != carving::DecimationTarget::ErrorBound)
  {
    std::reverse(targets.begin(), targets.end());
  }
  job.Decimation.Targets = std::move(targets);
  return job;
}

bool IsTarget(double target)
{
  return std::isfinite(target) && target >= 0.0;
}

} // namespace

vtkEnclosingDecimation::vtkEnclosingDecimation()
{
  this->SetNumberOfOutputPorts(2);
}

vtkEnclosingDecimation::~vtkEnclosingDecimation() = default;

void vtkEnclosingDecimation::AddTarget(double target)
{
  if (!IsTarget(target))
  {
    vtkErrorMacro(<< "A target cannot be " << target << ": the targets stay as they are.");
    return;
  }
  this->AllTargets.push_back(target);
  this->Modified();
}

void vtkEnclosingDecimation::ClearTargets()
{
  if (!this->AllTargets.empty())
  {
    this->AllTargets.clear();
    this->Modified();
  }
}

void vtkEnclosingDecimation::SetTarget(double target)
{
  if (this->AllTargets == std::vector<double>{ target })
  {
    return;
  }
  if (IsTarget(target))
  {
    this->AllTargets.clear();
  }
  this->AddTarget(target);
}

int vtkEnclosingDecimation::GetNumberOfTargets()
{
  return static_cast<int>(this->AllTargets.size());
}

double vtkEnclosingDecimation::GetTarget(int i)
{
  return i >= 0 && i < this->GetNumberOfTargets() ? this->AllTargets[i] : 0.0;
}

int vtkEnclosingDecimation::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkMultiBlockDataSet");
  return 1;
}

int vtkEnclosingDecimation::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  if (this->WasAborted)
  {
    this->SetAbortExecute(0); // not every version of the pipeline resets the request
  }
  vtkMultiBlockDataSet* all = vtkMultiBlockDataSet::GetData(out, 1);
  vtkPolyData* input = vtkPolyData::GetData(in[0]);
  if (!input) // the pipeline does not check the blocks of composite data
  {
    vtkErrorMacro(
      "A block without polygonal data cannot be decimated. Apply Extract Surface first.");
    return 0;
  }
  const bool good = WithinMemory(this, "", [&] { return this->Decimate(input, all); });
  if (!good)
  {
    all->Initialize();
  }
  else if (all->GetNumberOfBlocks() > 0)
  {
    vtkPolyData::GetData(out, 0)->ShallowCopy(all->GetBlock(0));
  }
  return good ? 1 : 0;
}

bool vtkEnclosingDecimation::Decimate(vtkPolyData* input, vtkMultiBlockDataSet* surfaces)
{
  CarverInput gathered;
  std::string error = gathered.Gather(input);
  if (!error.empty() || gathered.IsEmpty() || this->AllTargets.empty())
  {
    if (!error.empty())
    {
      vtkErrorMacro(<< error);
    }
    return error.empty();
  }
  carving::Job job = JobFor(this->TargetType, this->AllTargets);
  job.Mesh = std::move(gathered.Mesh);
  job.Decimation.Nested = this->Nested;
  RepeatedDecimation decimation;
  const HelperProcess::Outcome outcome = decimation.Run(
    job,
    [this](const carving::WorkProgress& progress)
    {
      this->UpdateProgress(progress.Fraction);
      return !IsAborted(this);
    },
    error);
  this->WasAborted = IsAborted(this);
  if (outcome == HelperProcess::Outcome::Aborted)
  {
    return true;
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return false;
  }
  const vtkSmartPointer<vtkPolyData> attributes = WithUsablePointData(input, gathered.Notes);
  WriteNotes(gathered.Notes, surfaces->GetFieldData());
  for (std::size_t i = job.Decimation.Targets.size(); i-- > 0;)
  {
    const auto& [origin, surface] = decimation.GetClosest(i);
    if (!surface.Reached)
    {
      vtkWarningMacro(<< "The target of " << job.Decimation.Targets[i]
                      << " is out of reach: the coarsest surface has "
                      << origin.Chain.Vertices - surface.Collapses
                      << " vertices. No further edge can collapse "
                      << "without a change of topology or a crossing.");
    }
    vtkNew<vtkPolyData> level;
    FillSurface(origin, surface, attributes, level);
    WriteNotes(gathered.Notes, level->GetFieldData());
    const unsigned int block = surfaces->GetNumberOfBlocks();
    surfaces->SetBlock(block, level);
    SetBlockName(surfaces, block, "LOD " + std::to_string(block));
  }
  return true;
}

void vtkEnclosingDecimation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TargetType: " << TargetTypeNames[this->TargetType] << "\n";
  os << indent << "Targets:";
  for (const double target : this->AllTargets)
  {
    os << " " << target;
  }
  os << "\n" << indent << "Nested: " << (this->Nested ? "On" : "Off") << "\n";
}
