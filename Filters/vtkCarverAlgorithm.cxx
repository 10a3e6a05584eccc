// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCarverAlgorithm.h"

#include "Convert/ArrayTools.h"
#include "Convert/IsSame.h"
#include "Objects/DataVersion.h"
#include "Objects/LevelCollection.h"
#include "Objects/ObjectExchange.h"
#include "Objects/SetNumber.h"
#include "Objects/TypedOutput.h"
#include "Session/CarverSession.h"
#include "Session/WithinMemory.h"
#include "vtkCarverProperty.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cmath>

namespace
{

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
  IsSame(Filter::EDGE_VOLUME, PriorityMeasure::EdgeVolume) &&
  IsSame(Filter::EDGE_DISTANCE, PriorityMeasure::EdgeDistance));
static_assert(IsSame(Filter::NONZERO_WINDING, SolidRule::NonzeroWinding) &&
  IsSame(Filter::EVEN_ODD, SolidRule::EvenOdd) &&
  IsSame(Filter::SURFACE_ONLY, SolidRule::SurfaceOnly));
static_assert(IsSame(Filter::TETGEN, carving::Strategy::TetGen) &&
  IsSame(Filter::RECOVER, carving::Strategy::Recover) &&
  IsSame(Filter::AUTO, carving::Strategy::Auto));
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

/** The state of the properties and the inputs. */
struct vtkCarverAlgorithm::Version
{
  vtkMTimeType Properties = 0;
  DataVersion Input;
  DataVersion Initial;
};

//------------------------------------------------------------------------------
vtkCarverAlgorithm::vtkCarverAlgorithm(int dimension)
  : Dimension(dimension)
  , Exchange(new ObjectExchange)
  , Done(new Version)
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
  ::SetNumber(this, name, number, greatest, property);
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::AddLevelTarget(double target)
{
  if (!std::isfinite(target) || target < 0.0)
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
  // With vtkPolyData alone on port 0, the pipeline would pass the leaves of a composite one by one
  // and keep the last result only, and the error for a grid would not name a remedy.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataObject" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

//------------------------------------------------------------------------------
int vtkCarverAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  // The type of port 0 follows OutputType, those of ports 1 and 2 follow the input's.
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkCarverAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  const bool composite = vtkCompositeDataSet::GetData(in[0]) != nullptr;
  const int types[] = { this->OutputType == PARTITIONED_COLLECTION
      ? VTK_PARTITIONED_DATA_SET_COLLECTION
      : VTK_MULTIBLOCK_DATA_SET,
    composite ? VTK_MULTIBLOCK_DATA_SET : VTK_UNSTRUCTURED_GRID,
    composite ? VTK_MULTIBLOCK_DATA_SET : VTK_TABLE };
  for (int port = 0; port < 3; ++port)
  {
    TypedOutput::SetOutputDataObject(types[port], out->GetInformationObject(port), true);
  }
  return 1;
}

//------------------------------------------------------------------------------
CarverSettings vtkCarverAlgorithm::GetSettings()
{
  CarverSettings settings;
  settings.Initial = static_cast<carving::InitialApproximation>(this->InitialApproximation);
  settings.Solid = static_cast<carving::SolidRule>(this->SolidRule);
  settings.Conformity = static_cast<carving::Conformity>(this->Conformity);
  settings.Strategy = static_cast<carving::Strategy>(this->Strategy);
  settings.EnclosingTolerance = this->EnclosingTolerance;
  settings.SnapTolerance = this->SnapTolerance;
  settings.NumberOfThreads =
    this->NumberOfThreads > 0 ? this->NumberOfThreads : vtkSMPTools::GetEstimatedNumberOfThreads();
  settings.Reuse = this->ReuseDecomposition;
  settings.AppendInput = this->AppendInput;
  settings.TimeLimit = this->TimeLimit;
  settings.MemoryLimit = this->MemoryLimit;
  settings.Carve.DepthExponent = this->DepthExponent;
  settings.Carve.BreadthRadius = this->BreadthRadius;
  settings.Carve.CarveExposed = this->CarveExposed;
  settings.Carve.CarveVoids = this->CarveVoids;
  settings.Carve.Budget = { this->MaximumComponents, this->MaximumTunnels, this->MaximumVoids };
  settings.NeedsSolid = carving::HasLimits(settings.Carve.Budget);
  settings.DepthIsDistance = this->DepthMeasure == DISTANCE;
  settings.ComputeError = this->ComputeError;
  settings.NumberOfLevels = this->NumberOfLevels;
  settings.LevelTargets = this->Targets;
  settings.TargetType = static_cast<carving::LevelTarget>(this->LevelTargetType);
  settings.Simplify = this->Dimension == 3 && this->LevelSimplification == ENCLOSING_COLLAPSE;
  const int measure = this->PriorityMeasure != AUTO_MEASURE ? this->PriorityMeasure
    : settings.Simplify                                     ? EDGE_DISTANCE
                                                            : LONGEST_EDGE;
  settings.Carve.Measure = static_cast<carving::PriorityMeasure>(measure);
  settings.MaximumVertices = this->MaximumVertices;
  const bool both = this->KeepBothFoldSides == AUTO
    ? carving::HasLimits(settings.Carve.Budget) || settings.Simplify
    : this->KeepBothFoldSides == BOTH_SIDES;
  settings.Folds = both ? carving::FoldSides::Both : carving::FoldSides::One;
  settings.ManifoldOutput = this->ManifoldOutput;
  settings.Stored = vtkSmartPointer<vtkFieldData>::New();
  for (const vtkCarverProperty& property : vtkCarverProperty::GetAll())
  {
    if (property.IsStored && property.IsInteger)
    {
      AddFieldValue<vtkIntArray>(
        settings.Stored, property.Name.c_str(), static_cast<int>(property.Get(this)));
    }
    else if (property.IsStored)
    {
      AddFieldValue<vtkDoubleArray>(settings.Stored, property.Name.c_str(), property.Get(this));
    }
  }
  return settings;
}

//------------------------------------------------------------------------------
int vtkCarverAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  if (this->WasAborted)
  {
    this->SetAbortExecute(0); // pipelines before VTK 9.3 do not reset the request
  }
  const CarverSettings settings = this->GetSettings();
  auto* collection = vtkPartitionedDataSetCollection::GetData(out, 0);
  vtkSmartPointer<vtkMultiBlockDataSet> levels = collection
    ? vtkSmartPointer<vtkMultiBlockDataSet>::New()
    : vtkSmartPointer<vtkMultiBlockDataSet>(vtkMultiBlockDataSet::GetData(out, 0));
  const CarverPorts ports = { levels, vtkDataObject::GetData(out, 1),
    vtkDataObject::GetData(out, 2) };
  vtkSmartPointer<vtkDataObject> input = vtkDataObject::GetData(in[0], 0);
  vtkSmartPointer<vtkPolyData> initial = vtkPolyData::GetData(in[1], 0);
  *this->Done = {};
  const Version version = { this->vtkCarverAlgorithm::GetMTime(), DataVersion(input),
    DataVersion(initial) };
  this->Exchange->SetController(this->Controller);
  const bool parallel = this->Exchange->IsParallel();
  if (parallel)
  {
    int numberOfMerged = 0;
    const auto gather = [&]
    {
      input = this->Exchange->Gather(input, numberOfMerged);
      initial = this->Exchange->GatherOnAll(initial);
      return true;
    };
    if (!WithinMemory(this, "", gather))
    {
      return 0;
    }
    if (numberOfMerged > 0)
    {
      vtkWarningMacro(<< numberOfMerged
                      << " object(s) were spread over several processes and have been "
                      << "gathered on one, since an object can only be carved whole.");
    }
  }
  const bool good = this->Session->Update(input, initial, settings, ports);
  this->WasAborted = IsAborted(this);
  if (good && !this->WasAborted)
  {
    *this->Done = version;
  }
  for (vtkDataObject* output : ports.GetAll())
  {
    if (!good)
    {
      output->Initialize();
    }
    if (parallel)
    {
      this->Exchange->Match(output);
    }
  }
  if (collection)
  {
    CopyLevels(levels, collection);
  }
  return good || this->WasAborted ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkCarverAlgorithm::IsUpToDate(vtkInformationVector** in)
{
  const bool here = this->Done->Properties == this->vtkCarverAlgorithm::GetMTime() &&
    this->Done->Input.IsOf(vtkDataObject::GetData(in[0])) &&
    this->Done->Initial.IsOf(vtkDataObject::GetData(in[1]));
  this->Exchange->SetController(this->Controller);
  return this->Exchange->IsTrueOnAll(here);
}

//------------------------------------------------------------------------------
void vtkCarverAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  for (const vtkCarverProperty& property : vtkCarverProperty::GetAll())
  {
    os << indent << property.Name << ": " << property.GetText(this) << "\n";
  }
  os << indent << "LevelTargets:";
  for (const double target : this->Targets)
  {
    os << " " << target;
  }
  os << "\n";
}
