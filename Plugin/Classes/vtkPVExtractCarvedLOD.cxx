// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVExtractCarvedLOD.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVExtractCarvedLOD);

//------------------------------------------------------------------------------
double* vtkPVExtractCarvedLOD::GetRange(int type, double target)
{
  if (!this->GetLevelTargetRange(type, this->Range))
  {
    this->Range[1] = 2.0 * target;
  }
  return this->Range;
}

//------------------------------------------------------------------------------
double* vtkPVExtractCarvedLOD::GetVertexRange()
{
  return this->GetRange(VERTICES, this->VertexTarget);
}

//------------------------------------------------------------------------------
double* vtkPVExtractCarvedLOD::GetTriangleRange()
{
  return this->GetRange(TRIANGLES, this->TriangleTarget);
}

//------------------------------------------------------------------------------
double* vtkPVExtractCarvedLOD::GetFeatureSizeRange()
{
  return this->GetRange(FEATURE_SIZE, this->FeatureSizeTarget);
}

//------------------------------------------------------------------------------
double* vtkPVExtractCarvedLOD::GetTunnelsRange()
{
  return this->GetRange(TUNNELS, this->TunnelsTarget);
}

//------------------------------------------------------------------------------
double* vtkPVExtractCarvedLOD::GetComponentRange()
{
  return this->GetRange(COMPONENTS, this->ComponentTarget);
}

//------------------------------------------------------------------------------
double* vtkPVExtractCarvedLOD::GetErrorBoundRange()
{
  return this->GetRange(ERROR_BOUND, this->ErrorBoundTarget);
}

//------------------------------------------------------------------------------
double* vtkPVExtractCarvedLOD::GetStepRange()
{
  return this->GetRange(STEP, this->StepTarget);
}

//------------------------------------------------------------------------------
int vtkPVExtractCarvedLOD::RequestData(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out)
{
  // The setter would mark the filter as changed while it executes.
  switch (this->LevelTargetType)
  {
    case TRIANGLES:
      this->LevelTarget = this->TriangleTarget;
      break;
    case FEATURE_SIZE:
      this->LevelTarget = this->FeatureSizeTarget;
      break;
    case TUNNELS:
      this->LevelTarget = this->TunnelsTarget;
      break;
    case COMPONENTS:
      this->LevelTarget = this->ComponentTarget;
      break;
    case ERROR_BOUND:
      this->LevelTarget = this->ErrorBoundTarget;
      break;
    case STEP:
      this->LevelTarget = this->StepTarget;
      break;
    default:
      this->LevelTarget = this->VertexTarget;
      break;
  }
  return this->Superclass::RequestData(request, in, out);
}

//------------------------------------------------------------------------------
void vtkPVExtractCarvedLOD::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VertexTarget: " << this->VertexTarget << "\n";
  os << indent << "TriangleTarget: " << this->TriangleTarget << "\n";
  os << indent << "FeatureSizeTarget: " << this->FeatureSizeTarget << "\n";
  os << indent << "TunnelsTarget: " << this->TunnelsTarget << "\n";
  os << indent << "ComponentTarget: " << this->ComponentTarget << "\n";
  os << indent << "ErrorBoundTarget: " << this->ErrorBoundTarget << "\n";
  os << indent << "StepTarget: " << this->StepTarget << "\n";
}
