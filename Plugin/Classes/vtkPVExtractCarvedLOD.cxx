// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVExtractCarvedLOD.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkPVExtractCarvedLOD);

//------------------------------------------------------------------------------
vtkPVExtractCarvedLOD::vtkPVExtractCarvedLOD()
{
  this->FollowTime = false;
}

//------------------------------------------------------------------------------
void vtkPVExtractCarvedLOD::SetVertexTarget(int target)
{
  const int clamped = std::max(target, 0);
  if (clamped != this->VertexTarget)
  {
    // The panel takes over the number that is shown, which changes nothing.
    const bool isShown = this->VertexTarget == 0 && clamped == this->ShownVertices;
    this->VertexTarget = clamped;
    if (!isShown)
    {
      this->Modified();
    }
  }
}

//------------------------------------------------------------------------------
void vtkPVExtractCarvedLOD::SetFeatureSizeTarget(double target)
{
  this->SetNumber("FeatureSizeTarget", target, this->FeatureSizeTarget);
}

//------------------------------------------------------------------------------
void vtkPVExtractCarvedLOD::SetErrorBoundTarget(double target)
{
  this->SetNumber("ErrorBoundTarget", target, this->ErrorBoundTarget);
}

//------------------------------------------------------------------------------
bool vtkPVExtractCarvedLOD::OfferTimes(vtkInformation* input, vtkInformation* output)
{
  const bool follow = this->FollowTime;
  this->FollowTime = true; // the setter would mark the filter as changed
  const bool offered = this->Superclass::OfferTimes(input, output);
  this->FollowTime = follow;
  return offered && follow;
}

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
  double range[2];
  this->ShownVertices = this->VertexTarget;
  if (this->LevelTargetType == VERTICES && this->VertexTarget == 0 &&
    this->GetLevelTargetRange(VERTICES, range))
  {
    // No object of a collection is asked for less than its hull.
    const double least = this->GetLeastCommonTarget(VERTICES);
    this->ShownVertices =
      static_cast<int>(std::lround(std::max(std::sqrt(range[0] * range[1]), least)));
  }
  const double targets[] = { static_cast<double>(this->ShownVertices),
    static_cast<double>(this->TriangleTarget), this->FeatureSizeTarget,
    static_cast<double>(this->TunnelsTarget), static_cast<double>(this->ComponentTarget),
    this->ErrorBoundTarget, static_cast<double>(this->StepTarget) };
  static_assert(VERTICES == 0 && TRIANGLES == 1 && FEATURE_SIZE == 2 && TUNNELS == 3 &&
      COMPONENTS == 4 && ERROR_BOUND == 5 && STEP == 6,
    "the order of the targets");
  // The setter would mark the filter as changed while it executes.
  this->LevelTarget = targets[this->LevelTargetType];
  return this->Superclass::RequestData(request, in, out);
}

//------------------------------------------------------------------------------
void vtkPVExtractCarvedLOD::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VertexTarget: " << this->VertexTarget << "\n";
  os << indent << "ShownVertices: " << this->ShownVertices << "\n";
  os << indent << "TriangleTarget: " << this->TriangleTarget << "\n";
  os << indent << "FeatureSizeTarget: " << this->FeatureSizeTarget << "\n";
  os << indent << "TunnelsTarget: " << this->TunnelsTarget << "\n";
  os << indent << "ComponentTarget: " << this->ComponentTarget << "\n";
  os << indent << "ErrorBoundTarget: " << this->ErrorBoundTarget << "\n";
  os << indent << "StepTarget: " << this->StepTarget << "\n";
}
