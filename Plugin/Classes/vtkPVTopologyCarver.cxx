// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTopologyCarver.h"

#include "LevelPort.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVTopologyCarver);

//------------------------------------------------------------------------------
vtkPVTopologyCarver::vtkPVTopologyCarver()
  : Level(new LevelPort(this))
{
  this->SetNumberOfOutputPorts(1 + this->GetNumberOfOutputPorts());
}

//------------------------------------------------------------------------------
vtkPVTopologyCarver::~vtkPVTopologyCarver() = default;

//------------------------------------------------------------------------------
void vtkPVTopologyCarver::SetExtractor(vtkPVExtractCarvedLOD* extractor)
{
  if (this->Level->SetExtractor(extractor))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPVExtractCarvedLOD* vtkPVTopologyCarver::GetExtractor()
{
  return this->Level->GetExtractor();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVTopologyCarver::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Level->GetExtractor()->GetMTime());
}

//------------------------------------------------------------------------------
int vtkPVTopologyCarver::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port > 0)
  {
    return this->Superclass::FillOutputPortInformation(port - 1, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // follows the input's
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVTopologyCarver::RequestDataObject(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out)
{
  this->Level->RequestDataObject(in, out);
  return this->Superclass::RequestDataObject(request, in, LevelPort::GetCarverPorts(out));
}

//------------------------------------------------------------------------------
int vtkPVTopologyCarver::RequestInformation(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  this->Level->RequestInformation(in, out);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVTopologyCarver::RequestData(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out)
{
  return this->Level->RequestData(this->Superclass::GetMTime(), in, out,
    [&](vtkInformationVector* ports) { return this->Superclass::RequestData(request, in, ports); });
}
