// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVCarver.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPVExtractCarvedLOD.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace
{

constexpr int NumberOfCarverPorts = 3;
constexpr int StreamPort = 1; // of the carver's own ports

/** The carver's own ports. */
vtkSmartPointer<vtkInformationVector> GetCarverPorts(vtkInformationVector* out)
{
  auto ports = vtkSmartPointer<vtkInformationVector>::New();
  for (int port = 0; port < NumberOfCarverPorts; ++port)
  {
    ports->Append(out->GetInformationObject(port + 1));
  }
  return ports;
}

} // namespace

//------------------------------------------------------------------------------
vtkPVCarver::vtkPVCarver(int dimension)
  : vtkCarverAlgorithm(dimension)
  , Extractor(vtkSmartPointer<vtkPVExtractCarvedLOD>::New())
{
  this->SetNumberOfOutputPorts(1 + NumberOfCarverPorts);
}

//------------------------------------------------------------------------------
vtkPVCarver::~vtkPVCarver() = default;

//------------------------------------------------------------------------------
void vtkPVCarver::SetExtractor(vtkPVExtractCarvedLOD* extractor)
{
  if (extractor && extractor != this->Extractor)
  {
    this->Extractor = extractor;
    extractor->SetLevelSimplification(this->LevelSimplification);
    extractor->SetMaximumVertices(this->MaximumVertices);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVCarver::SetLevelSimplification(int value)
{
  this->Superclass::SetLevelSimplification(value);
  this->Extractor->SetLevelSimplification(value);
}

//------------------------------------------------------------------------------
void vtkPVCarver::SetMaximumVertices(int value)
{
  this->Superclass::SetMaximumVertices(value);
  this->Extractor->SetMaximumVertices(value);
}

//------------------------------------------------------------------------------
vtkPVExtractCarvedLOD* vtkPVCarver::GetExtractor()
{
  return this->Extractor;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVCarver::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Extractor->GetMTime());
}

//------------------------------------------------------------------------------
int vtkPVCarver::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port > 0)
  {
    return this->Superclass::FillOutputPortInformation(port - 1, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // follows the input's
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVCarver::RequestDataObject(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out)
{
  // The levels of port 0 have the structure of the input, as those of the stream do.
  this->Extractor->ProcessRequest(request, in, out);
  return this->Superclass::RequestDataObject(request, in, GetCarverPorts(out));
}

//------------------------------------------------------------------------------
int vtkPVCarver::RequestInformation(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  this->OffersTime =
    this->Extractor->OfferTimes(in[0]->GetInformationObject(0), out->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVCarver::RequestData(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out)
{
  const auto ports = GetCarverPorts(out);
  if (this->IsUpToDate(in))
  {
    for (int port = 0; port < NumberOfCarverPorts; ++port)
    {
      vtkDataObject::GetData(ports, port)->ShallowCopy(this->Kept[port]);
    }
  }
  else if (!this->CarveAndKeep(request, in, ports))
  {
    vtkDataObject::GetData(out, 0)->Initialize();
    return this->GetAbortExecute() ? 1 : 0;
  }
  this->ExtractLevel(out);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkPVCarver::CarveAndKeep(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* ports)
{
  this->Kept = {};
  const bool good = this->Superclass::RequestData(request, in, ports) != 0;
  this->SetProgressText(nullptr); // all stages are over
  if (this->GetAbortExecute())
  {
    // Without a message, an empty view would be all that the user sees.
    vtkWarningMacro(
      "The carving was stopped. To start it again, change a property and press Apply.");
  }
  if (!good || this->GetAbortExecute())
  {
    return false;
  }
  for (int port = 0; port < NumberOfCarverPorts; ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(ports, port);
    this->Kept[port].TakeReference(output->NewInstance());
    this->Kept[port]->ShallowCopy(output);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPVCarver::ExtractLevel(vtkInformationVector* out)
{
  using vtkSDDP = vtkStreamingDemandDrivenPipeline;
  vtkDataObject* level = vtkDataObject::GetData(out, 0);
  this->Extractor->SetInputDataObject(this->Kept[StreamPort]);
  // If another port is asked for first, only that port has the time.
  vtkInformation* asked = nullptr;
  for (int port = NumberOfCarverPorts; port >= 0 && this->OffersTime; --port)
  {
    vtkInformation* info = out->GetInformationObject(port);
    asked = info->Has(vtkSDDP::UPDATE_TIME_STEP()) ? info : asked;
  }
  if (asked)
  {
    const double now = asked->Get(vtkSDDP::UPDATE_TIME_STEP());
    this->Extractor->UpdateTimeStep(now);
    level->ShallowCopy(this->Extractor->GetOutputDataObject(0));
    level->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), now);
  }
  else
  {
    this->Extractor->GetOutputInformation(0)->Remove(vtkSDDP::UPDATE_TIME_STEP());
    this->Extractor->Update();
    level->ShallowCopy(this->Extractor->GetOutputDataObject(0));
  }
}

//------------------------------------------------------------------------------
void vtkPVCarver::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Extractor: " << this->Extractor << "\n";
}
