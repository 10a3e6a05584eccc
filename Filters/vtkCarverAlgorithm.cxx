// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCarverAlgorithm.h"

#include "Objects/CompositeTree.h"
#include "Objects/ObjectExchange.h"
#include "Session/CarverSession.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace
{

/** Whether an enumerator of the filter has the value of the core's, as which it is passed on. */
template <class Enumerator>
constexpr bool IsSame(int filters, Enumerator cores)
{
  return filters == static_cast<int>(cores);
}

using Filter = vtkCarverAlgorithm;
using carving::Conformity;
using carving::FoldSides;
using carving::InitialApproximation;
using carving::LevelTarget;
using carving::PriorityMeasure;
using carving::SolidRule;
static_assert(IsSame(Filter::CONVEX_HULL, InitialApproximation::ConvexHull) &&
  IsSame(Filter::BOUNDING_BOX, InitialApproximation::BoundingBox) &&
  IsSame(Filter::CUSTOM, InitialApproximation::Custom));
static_assert(IsSame(Filter::LONGEST_EDGE, PriorityMeasure::LongestEdge) &&
  IsSame(Filter::VOLUME, PriorityMeasure::Volume) &&
  IsSame(Filter::CIRCUMRADIUS, PriorityMeasure::Circumradius) &&
  IsSame(Filter::EDGE_VOLUME, PriorityMeasure::EdgeVolume));
static_assert(IsSame(Filter::NONZERO_WINDING, SolidRule::NonzeroWinding) &&
  IsSame(Filter::EVEN_ODD, SolidRule::EvenOdd) &&
  IsSame(Filter::SURFACE_ONLY, SolidRule::SurfaceOnly));
static_assert(IsSame(Filter::EXACT, Conformity::Exact) &&
  IsSame(Filter::ENCLOSING, Conformity::Enclosing) && IsSame(Filter::AUTO, Conformity::Auto));
static_assert(
  IsSame(Filter::ONE_SIDE, FoldSides::One) && IsSame(Filter::BOTH_SIDES, FoldSides::Both));
static_assert(IsSame(Filter::VERTICES, LevelTarget::Vertices) &&
  IsSame(Filter::TRIANGLES, LevelTarget::Triangles) &&
  IsSame(Filter::FEATURE_SIZE, LevelTarget::FeatureSize) &&
  IsSame(Filter::TUNNELS, LevelTarget::Tunnels) &&
  IsSame(Filter::COMPONENTS, LevelTarget::Components) &&
  IsSame(Filter::ERROR_BOUND, LevelTarget::ErrorBound) && IsSame(Filter::STEP, LevelTarget::Step));

} // namespace

//------------------------------------------------------------------------------
vtkCarverAlgorithm::vtkCarverAlgorithm(int dimension)
  : Exchange(new ObjectExchange)
{
  if (dimension == 2)
  {
    this->Session.reset(new CarverSession<2>(this));
  }
  else
  {
    this->Session.reset(new CarverSession<3>(this));
  }
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkCarverAlgorithm::~vtkCarverAlgorithm()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
vtkCxxSetObjectMacro(vtkCarverAlgorithm, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::SetNumber(
  const char* name, double number, double greatest, double& property)
{
  if (!std::isfinite(number))
  {
    vtkErrorMacro(<< name << " cannot be " << number << ": it stays " << property << ".");
    return;
  }
  const double clamped = std::clamp(number, 0.0, greatest);
  if (clamped != property)
  {
    property = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::SetDepthExponent(double value)
{
  this->SetNumber("DepthExponent", value, VTK_DOUBLE_MAX, this->DepthExponent);
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::SetBreadthRadius(double value)
{
  this->SetNumber("BreadthRadius", value, VTK_DOUBLE_MAX, this->BreadthRadius);
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::SetEnclosingTolerance(double value)
{
  this->SetNumber("EnclosingTolerance", value, 1.0, this->EnclosingTolerance);
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::SetSnapTolerance(double value)
{
  this->SetNumber("SnapTolerance", value, 1.0, this->SnapTolerance);
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::SetTimeLimit(double value)
{
  this->SetNumber("TimeLimit", value, VTK_DOUBLE_MAX, this->TimeLimit);
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::SetMemoryLimit(double value)
{
  this->SetNumber("MemoryLimit", value, VTK_DOUBLE_MAX, this->MemoryLimit);
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::AddLevelTarget(double target)
{
  if (!std::isfinite(target))
  {
    vtkErrorMacro(<< "A level target cannot be " << target << ": none is added.");
    return;
  }
  this->Targets.push_back(target);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::ClearLevelTargets()
{
  if (!this->Targets.empty())
  {
    this->Targets.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkCarverAlgorithm::GetNumberOfLevelTargets()
{
  return static_cast<int>(this->Targets.size());
}

//------------------------------------------------------------------------------
double vtkCarverAlgorithm::GetLevelTarget(int index)
{
  return index >= 0 && index < this->GetNumberOfLevelTargets() ? this->Targets[index] : 0.0;
}

//------------------------------------------------------------------------------
int vtkCarverAlgorithm::GetNumberOfStages()
{
  return NumberOfCarverStages;
}

//------------------------------------------------------------------------------
const char* vtkCarverAlgorithm::GetStageName(int stage)
{
  return stage < 0 || stage >= NumberOfCarverStages ? nullptr : GetCarverStageName(stage);
}

//------------------------------------------------------------------------------
double vtkCarverAlgorithm::GetStageSeconds(int stage)
{
  return stage < 0 || stage >= NumberOfCarverStages ? 0.0 : this->Session->GetStageSeconds(stage);
}

//------------------------------------------------------------------------------
int vtkCarverAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  // Anything on port 0: with vtkPolyData alone the pipeline would feed the leaves of a composite one by
  // one and keep the last result only, and would not say what to do about a grid.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataObject" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

//------------------------------------------------------------------------------
int vtkCarverAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  // The types of ports 1 and 2 follow the input's.
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkMultiBlockDataSet" : "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkCarverAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  const bool composite = vtkCompositeDataSet::GetData(in[0]) != nullptr;
  const char* types[] = { "vtkMultiBlockDataSet",
    composite ? "vtkMultiBlockDataSet" : "vtkUnstructuredGrid",
    composite ? "vtkMultiBlockDataSet" : "vtkTable" };
  for (int port = 0; port < 3; ++port)
  {
    SetOutputClass(out, port, types[port]);
  }
  return 1;
}

//------------------------------------------------------------------------------
CarverSettings vtkCarverAlgorithm::GetSettings() const
{
  CarverSettings settings;
  settings.Initial = static_cast<carving::InitialApproximation>(this->InitialApproximation);
  settings.Solid = static_cast<carving::SolidRule>(this->SolidRule);
  settings.Conformity = static_cast<carving::Conformity>(this->Conformity);
  settings.EnclosingTolerance = this->EnclosingTolerance;
  settings.SnapTolerance = this->SnapTolerance;
  settings.AppendInput = this->AppendInput;
  settings.TimeLimit = this->TimeLimit;
  settings.MemoryLimit = this->MemoryLimit;
  settings.Carve.Measure = static_cast<carving::PriorityMeasure>(this->PriorityMeasure);
  settings.Carve.DepthExponent = this->DepthExponent;
  settings.Carve.BreadthRadius = this->BreadthRadius;
  settings.Carve.CarveExposed = this->CarveExposed;
  settings.Carve.CarveVoids = this->CarveVoids;
  settings.Carve.Budget = { this->MaximumComponents, this->MaximumTunnels, this->MaximumVoids };
  settings.DepthIsDistance = this->DepthMeasure == DISTANCE;
  settings.ComputeError = this->ComputeError;
  settings.NumberOfLevels = this->NumberOfLevels;
  settings.LevelTargets = this->Targets;
  settings.TargetType = static_cast<carving::LevelTarget>(this->LevelTargetType);
  const bool both = this->KeepBothFoldSides == AUTO ? carving::HasLimits(settings.Carve.Budget)
                                                    : this->KeepBothFoldSides == BOTH_SIDES;
  settings.Folds = both ? carving::FoldSides::Both : carving::FoldSides::One;
  settings.ManifoldOutput = this->ManifoldOutput;
  return settings;
}

//------------------------------------------------------------------------------
int vtkCarverAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  if (this->WasAborted)
  {
    this->SetAbortExecute(0); // which only pipelines before VTK 9.3 do themselves
  }
  const CarverSettings settings = this->GetSettings();
  const CarverPorts ports = { vtkMultiBlockDataSet::GetData(out, 0), vtkDataObject::GetData(out, 1),
    vtkDataObject::GetData(out, 2) };
  vtkSmartPointer<vtkDataObject> input = vtkDataObject::GetData(in[0], 0);
  vtkSmartPointer<vtkPolyData> initial = vtkPolyData::GetData(in[1], 0);
  this->Exchange->SetController(this->Controller);
  const bool parallel = this->Exchange->IsParallel();
  if (parallel)
  {
    int numberOfMerged = 0;
    input = this->Exchange->Gather(input, numberOfMerged);
    initial = this->Exchange->GatherOnAll(initial);
    if (numberOfMerged > 0)
    {
      vtkWarningMacro(<< numberOfMerged
                      << " object(s) were spread over several processes and have been "
                      << "gathered on one, since an object can only be carved whole.");
    }
  }
  const bool good = this->Session->Update(input, initial, settings, ports);
  if (!good)
  {
    ports.Levels->Initialize();
    ports.Stream->Initialize();
    ports.Profile->Initialize();
  }
  this->WasAborted = IsAborted(this);
  if (parallel)
  {
    this->Exchange->Match(ports.Levels);
    this->Exchange->Match(ports.Stream);
    this->Exchange->Match(ports.Profile);
  }
  return good || this->WasAborted ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  constexpr const char* initials[] = { "CONVEX_HULL", "BOUNDING_BOX", "CUSTOM" };
  constexpr const char* measures[] = { "LONGEST_EDGE", "VOLUME", "CIRCUMRADIUS", "EDGE_VOLUME" };
  constexpr const char* depths[] = { "HIERARCHY", "DISTANCE" };
  constexpr const char* rules[] = { "NONZERO_WINDING", "EVEN_ODD", "SURFACE_ONLY" };
  constexpr const char* conformities[] = { "EXACT", "ENCLOSING", "AUTO" };
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "InitialApproximation: " << initials[this->InitialApproximation] << "\n";
  os << indent << "PriorityMeasure: " << measures[this->PriorityMeasure] << "\n";
  os << indent << "DepthExponent: " << this->DepthExponent << "\n";
  os << indent << "DepthMeasure: " << depths[this->DepthMeasure] << "\n";
  os << indent << "BreadthRadius: " << this->BreadthRadius << "\n";
  os << indent << "CarveExposed: " << (this->CarveExposed ? "On" : "Off") << "\n";
  os << indent << "CarveVoids: " << (this->CarveVoids ? "On" : "Off") << "\n";
  os << indent << "MaximumComponents: " << this->MaximumComponents << "\n";
  os << indent << "MaximumTunnels: " << this->MaximumTunnels << "\n";
  os << indent << "MaximumVoids: " << this->MaximumVoids << "\n";
  os << indent << "SolidRule: " << rules[this->SolidRule] << "\n";
  os << indent << "Conformity: " << conformities[this->Conformity] << "\n";
  os << indent << "EnclosingTolerance: " << this->EnclosingTolerance << "\n";
  os << indent << "SnapTolerance: " << this->SnapTolerance << "\n";
  os << indent << "AppendInput: " << (this->AppendInput ? "On" : "Off") << "\n";
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  constexpr const char* folds[] = { "ONE_SIDE", "BOTH_SIDES", "AUTO" };
  os << indent << "KeepBothFoldSides: " << folds[this->KeepBothFoldSides] << "\n";
  os << indent << "ManifoldOutput: " << (this->ManifoldOutput ? "On" : "Off") << "\n";
  os << indent << "ComputeError: " << (this->ComputeError ? "On" : "Off") << "\n";
  os << indent << "LevelTargetType: "
     << carving::LevelTargetName(static_cast<carving::LevelTarget>(this->LevelTargetType)) << "\n";
  os << indent << "LevelTargets:";
  for (const double target : this->Targets)
  {
    os << " " << target;
  }
  os << "\n";
}
