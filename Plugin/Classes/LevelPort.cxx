// SPDX-License-Identifier: BSD-3-Clause
#include "LevelPort.h"

#include "Objects/CompositeTree.h"
#include "vtkCarverAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace
{

constexpr int NumberOfCarverPorts = 3;
constexpr int StreamPort = 1; // of the carver

vtkMTimeType GetInputTime(vtkInformationVector* in)
{
  vtkDataObject* input = vtkDataObject::GetData(in, 0);
  return input ? input->GetMTime() : 0;
}

} // namespace

LevelPort::LevelPort(vtkCarverAlgorithm* carver)
  : Carver(carver)
  , Extractor(vtkSmartPointer<vtkPVExtractCarvedLOD>::New())
{
}

bool LevelPort::SetExtractor(vtkPVExtractCarvedLOD* extractor)
{
  if (!extractor || extractor == this->Extractor)
  {
    return false;
  }
  this->Extractor = extractor;
  return true;
}

vtkSmartPointer<vtkInformationVector> LevelPort::GetCarverPorts(vtkInformationVector* out)
{
  auto ports = vtkSmartPointer<vtkInformationVector>::New();
  for (int port = 0; port < NumberOfCarverPorts; ++port)
  {
    ports->Append(out->GetInformationObject(port + 1));
  }
  return ports;
}

void LevelPort::RequestDataObject(vtkInformationVector** in, vtkInformationVector* out)
{
  SetOutputClass(
    out, 0, vtkCompositeDataSet::GetData(in[0]) ? "vtkMultiBlockDataSet" : "vtkPolyData");
}

void LevelPort::RequestInformation(vtkInformationVector** in, vtkInformationVector* out)
{
  this->OffersTime =
    this->Extractor->OfferTimes(in[0]->GetInformationObject(0), out->GetInformationObject(0));
}

bool LevelPort::IsCurrent(const std::array<vtkMTimeType, 3>& times) const
{
  int current = this->Kept[0] && times == this->Times;
  vtkMultiProcessController* controller = this->Carver->GetController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    // Carving is a joint work of all processes.
    const int own = current;
    controller->AllReduce(&own, &current, 1, vtkCommunicator::MIN_OP);
  }
  return current != 0;
}

int LevelPort::RequestData(vtkMTimeType time, vtkInformationVector** in, vtkInformationVector* out,
  const std::function<int(vtkInformationVector*)>& carve)
{
  const auto ports = LevelPort::GetCarverPorts(out);
  const std::array<vtkMTimeType, 3> times = { time, GetInputTime(in[0]), GetInputTime(in[1]) };
  if (!this->IsCurrent(times))
  {
    this->Kept = {};
    const bool good = carve(ports) != 0;
    this->Carver->SetProgressText(nullptr); // no stage any more
    if (this->Carver->GetAbortExecute())
    {
      // Or an empty view would be all that there is to see.
      vtkWarningWithObjectMacro(this->Carver,
        "The carving was stopped. To start it again, change a property and press Apply.");
    }
    if (!good || this->Carver->GetAbortExecute())
    {
      vtkDataObject::GetData(out, 0)->Initialize();
      return good;
    }
    for (int port = 0; port < NumberOfCarverPorts; ++port)
    {
      vtkDataObject* output = vtkDataObject::GetData(ports, port);
      this->Kept[port].TakeReference(output->NewInstance());
      this->Kept[port]->ShallowCopy(output);
    }
    this->Times = times;
  }
  else
  {
    for (int port = 0; port < NumberOfCarverPorts; ++port)
    {
      vtkDataObject::GetData(ports, port)->ShallowCopy(this->Kept[port]);
    }
  }
  using vtkSDDP = vtkStreamingDemandDrivenPipeline;
  vtkDataObject* level = vtkDataObject::GetData(out, 0);
  this->Extractor->SetInputDataObject(this->Kept[StreamPort]);
  // Where another port is asked for first, it is the only one to know the time.
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
  return 1;
}
