// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTopologyCarver.h"

#include "CarverSession.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkTopologyCarver);

//------------------------------------------------------------------------------
vtkTopologyCarver::vtkTopologyCarver()
  : Session(new CarverSession(this))
{
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkTopologyCarver::~vtkTopologyCarver() = default;

//------------------------------------------------------------------------------
void vtkTopologyCarver::AddLevelTarget(double target)
{
  this->Targets.push_back(target);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTopologyCarver::ClearLevelTargets()
{
  if (!this->Targets.empty())
  {
    this->Targets.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::GetNumberOfLevelTargets()
{
  return static_cast<int>(this->Targets.size());
}

//------------------------------------------------------------------------------
double vtkTopologyCarver::GetLevelTarget(int index)
{
  return index >= 0 && index < this->GetNumberOfLevelTargets() ? this->Targets[index] : 0.0;
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::GetNumberOfStages()
{
  return CarverSession::NumberOfStages;
}

//------------------------------------------------------------------------------
const char* vtkTopologyCarver::GetStageName(int stage)
{
  return stage < 0 || stage >= CarverSession::NumberOfStages ? nullptr
                                                             : CarverSession::GetStageName(stage);
}

//------------------------------------------------------------------------------
double vtkTopologyCarver::GetStageSeconds(int stage)
{
  return stage < 0 || stage >= CarverSession::NumberOfStages
    ? 0.0
    : this->Session->GetStageSeconds(stage);
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  // Declared too, or the pipeline would feed the leaves one by one and keep the last result only.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::FillOutputPortInformation(int port, vtkInformation* info)
{
  // The types of ports 1 and 2 follow the input's.
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkMultiBlockDataSet" : "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::RequestDataObject(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  const bool composite = vtkCompositeDataSet::GetData(in[0]) != nullptr;
  const char* types[] = { "vtkMultiBlockDataSet",
    composite ? "vtkMultiBlockDataSet" : "vtkUnstructuredGrid",
    composite ? "vtkMultiBlockDataSet" : "vtkTable" };
  for (int port = 0; port < 3; ++port)
  {
    vtkDataObject* current = vtkDataObject::GetData(out, port);
    if (!current || !current->IsA(types[port]))
    {
      vtkSmartPointer<vtkDataObject> output;
      output.TakeReference(vtkDataObjectTypes::NewDataObject(types[port]));
      out->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), output);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkTopologyCarver::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  CarverSettings settings;
  settings.Initial = static_cast<carving::InitialApproximation>(this->InitialApproximation);
  settings.Solid = static_cast<carving::SolidRule>(this->SolidRule);
  settings.Carve.Measure = static_cast<carving::PriorityMeasure>(this->PriorityMeasure);
  settings.Carve.DepthExponent = this->DepthExponent;
  settings.Carve.BreadthRadius = this->BreadthRadius;
  settings.Carve.CarveExposed = this->CarveExposed;
  settings.Carve.CarveVoids = this->CarveVoids;
  settings.DepthIsDistance = this->DepthMeasure == DISTANCE;
  settings.NumberOfLevels = this->NumberOfLevels;
  settings.LevelTargets = this->Targets;
  settings.TargetsAreTriangles = this->LevelTargetType == TRIANGLES;
  const CarverPorts ports = { vtkMultiBlockDataSet::GetData(out, 0), vtkDataObject::GetData(out, 1),
    vtkDataObject::GetData(out, 2) };
  if (this->Session->Update(vtkDataObject::GetData(in[0], 0), settings, ports))
  {
    return 1;
  }
  ports.Levels->Initialize();
  ports.Stream->Initialize();
  ports.Profile->Initialize();
  return this->GetAbortExecute() ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkTopologyCarver::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  constexpr const char* initials[] = { "CONVEX_HULL", "BOUNDING_BOX" };
  constexpr const char* measures[] = { "LONGEST_EDGE", "VOLUME", "CIRCUMRADIUS", "EDGE_VOLUME" };
  constexpr const char* depths[] = { "HIERARCHY", "DISTANCE" };
  constexpr const char* rules[] = { "NONZERO_WINDING", "EVEN_ODD", "SURFACE_ONLY" };
  os << indent << "InitialApproximation: " << initials[this->InitialApproximation] << "\n";
  os << indent << "PriorityMeasure: " << measures[this->PriorityMeasure] << "\n";
  os << indent << "DepthExponent: " << this->DepthExponent << "\n";
  os << indent << "DepthMeasure: " << depths[this->DepthMeasure] << "\n";
  os << indent << "BreadthRadius: " << this->BreadthRadius << "\n";
  os << indent << "CarveExposed: " << (this->CarveExposed ? "On" : "Off") << "\n";
  os << indent << "CarveVoids: " << (this->CarveVoids ? "On" : "Off") << "\n";
  os << indent << "SolidRule: " << rules[this->SolidRule] << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent
     << "LevelTargetType: " << (this->LevelTargetType == VERTICES ? "VERTICES" : "TRIANGLES")
     << "\n";
  os << indent << "LevelTargets:";
  for (const double target : this->Targets)
  {
    os << " " << target;
  }
  os << "\n";
}
