// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVContourCarver.h"

#include "LevelPort.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVContourCarver);

//------------------------------------------------------------------------------
vtkPVContourCarver::vtkPVContourCarver()
  : Level(new LevelPort(this))
{
  this->SetNumberOfOutputPorts(1 + this->GetNumberOfOutputPorts());
}

//------------------------------------------------------------------------------
vtkPVContourCarver::~vtkPVContourCarver() = default;

//------------------------------------------------------------------------------
void vtkPVContourCarver::SetExtractor(vtkPVExtractCarvedLOD* extractor)
{
  if (this->Level->SetExtractor(extractor))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPVExtractCarvedLOD* vtkPVContourCarver::GetExtractor()
{
  return this->Level->GetExtractor();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVContourCarver::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Level->GetExtractor()->GetMTime());
}

//------------------------------------------------------------------------------
int vtkPVContourCarver::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port > 0)
  {
    return this->Superclass::FillOutputPortInformation(port - 1, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // follows the input's
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVContourCarver::RequestDataObject(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out)
{
  this->Level->RequestDataObject(in, out);
  return this->Superclass::RequestDataObject(request, in, LevelPort::GetCarverPorts(out));
}

//------------------------------------------------------------------------------
int vtkPVContourCarver::RequestInformation(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  this->Level->RequestInformation(in, out);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVContourCarver::RequestData(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out)
{
  return this->Level->RequestData(this->Superclass::GetMTime(), in, out,
    [&](vtkInformationVector* ports) { return this->Superclass::RequestData(request, in, ports); });
}
