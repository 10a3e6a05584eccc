// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExtractCarvedLOD.h"

#include "Convert/IsSame.h"
#include "Convert/LevelOutput.h"
#include "Convert/ProfileInput.h"
#include "Convert/StreamOutput.h"
#include "Core/Measure/LevelSelection.h"
#include "Objects/CompositeTree.h"
#include "Objects/SetNumber.h"
#include "Objects/TypedOutput.h"
#include "Session/PreparedStreams.h"
#include "Session/WithinMemory.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{

/** The data object on the input port as it is now, or null. */
vtkDataObject* GetInputOf(vtkAlgorithm* filter)
{
  return filter->GetNumberOfInputConnections(0) > 0 ? filter->GetInputDataObject(0, 0) : nullptr;
}

} // namespace

static_assert(IsSame(vtkExtractCarvedLOD::VERTICES, carving::LevelTarget::Vertices) &&
  IsSame(vtkExtractCarvedLOD::TRIANGLES, carving::LevelTarget::Triangles) &&
  IsSame(vtkExtractCarvedLOD::FEATURE_SIZE, carving::LevelTarget::FeatureSize) &&
  IsSame(vtkExtractCarvedLOD::TUNNELS, carving::LevelTarget::Tunnels) &&
  IsSame(vtkExtractCarvedLOD::COMPONENTS, carving::LevelTarget::Components) &&
  IsSame(vtkExtractCarvedLOD::ERROR_BOUND, carving::LevelTarget::ErrorBound) &&
  IsSame(vtkExtractCarvedLOD::STEP, carving::LevelTarget::Step));

vtkStandardNewMacro(vtkExtractCarvedLOD);

//------------------------------------------------------------------------------
vtkExtractCarvedLOD::vtkExtractCarvedLOD()
  : Streams(new PreparedStreams)
{
}

//------------------------------------------------------------------------------
vtkExtractCarvedLOD::~vtkExtractCarvedLOD() = default;

//------------------------------------------------------------------------------
vtkTypeBool vtkExtractCarvedLOD::ProcessRequest(
  vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    const bool composite = vtkCompositeDataSet::GetData(in[0]) != nullptr;
    TypedOutput::SetOutputDataObject(
      composite ? VTK_MULTIBLOCK_DATA_SET : VTK_POLY_DATA, out->GetInformationObject(0), true);
    return 1;
  }
  return this->Superclass::ProcessRequest(request, in, out);
}

//------------------------------------------------------------------------------
int vtkExtractCarvedLOD::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  // Without this type, the pipeline would pass the leaves one by one, without their time.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkExtractCarvedLOD::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // follows the input's
  return 1;
}

//------------------------------------------------------------------------------
bool vtkExtractCarvedLOD::OfferTimes(vtkInformation* input, vtkInformation* output)
{
  using vtkSDDP = vtkStreamingDemandDrivenPipeline;
  // Some readers give a single time step to data that do not change.
  if (input->Has(vtkSDDP::TIME_STEPS()) && input->Length(vtkSDDP::TIME_STEPS()) > 1)
  {
    return false;
  }
  if (!this->FollowTime)
  {
    output->Remove(vtkSDDP::TIME_STEPS());
    output->Remove(vtkSDDP::TIME_RANGE());
    return false;
  }
  std::vector<double> times(this->NumberOfTimeSteps);
  std::iota(times.begin(), times.end(), 0.0);
  const double range[] = { times.front(), times.back() };
  output->Set(vtkSDDP::TIME_STEPS(), times.data(), this->NumberOfTimeSteps);
  output->Set(vtkSDDP::TIME_RANGE(), range, 2);
  return true;
}

//------------------------------------------------------------------------------
int vtkExtractCarvedLOD::RequestInformation(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  this->OffersTime = this->OfferTimes(in[0]->GetInformationObject(0), out->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkExtractCarvedLOD::SetLevelTarget(double target)
{
  this->SetNumber("LevelTarget", target, this->LevelTarget);
}

//------------------------------------------------------------------------------
void vtkExtractCarvedLOD::SetNumber(const char* name, double number, double& property)
{
  ::SetNumber(this, name, number, VTK_DOUBLE_MAX, property);
}

//------------------------------------------------------------------------------
bool vtkExtractCarvedLOD::GetLevelTargetRange(int type, double range[2])
{
  range[0] = range[1] = 0.0;
  if (type < VERTICES || type > STEP)
  {
    return false;
  }
  const std::vector<TargetRange> ranges =
    PreparedStreams::GetTargetRanges(GetInputOf(this), static_cast<carving::LevelTarget>(type));
  if (ranges.empty())
  {
    return false;
  }
  range[0] = HUGE_VAL;
  for (const auto& [least, greatest, leastSimplified] : ranges)
  {
    range[0] =
      std::min(range[0], this->LevelSimplification == ENCLOSING_COLLAPSE ? leastSimplified : least);
    range[1] = std::max(range[1], greatest);
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkExtractCarvedLOD::GetLeastCommonTarget(int type)
{
  double least = 0.0;
  for (const TargetRange& range :
    PreparedStreams::GetTargetRanges(GetInputOf(this), static_cast<carving::LevelTarget>(type)))
  {
    least = std::max(least, range.Least);
  }
  return least;
}

//------------------------------------------------------------------------------
bool vtkExtractCarvedLOD::GetProfile(vtkTable* profile)
{
  profile->Initialize();
  const std::vector<carving::Profile> profiles = this->Streams->GetProfiles(GetInputOf(this));
  if (profiles.empty())
  {
    return false;
  }
  FillProfile(profiles.front(), profile);
  return true;
}

//------------------------------------------------------------------------------
int vtkExtractCarvedLOD::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  using vtkSDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = out->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(outInfo);
  output->GetFieldData()->Initialize(); // the pipeline has copied the stream's
  const bool byTime = this->OffersTime && outInfo->Has(vtkSDDP::UPDATE_TIME_STEP());
  const double time = byTime ? outInfo->Get(vtkSDDP::UPDATE_TIME_STEP()) : 0.0;
  if (byTime)
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
  auto* levels = vtkMultiBlockDataSet::SafeDownCast(output);
  const bool good = levels
    ? this->ExtractTree(vtkDataObject::GetData(in[0]), "", byTime ? &time : nullptr, levels)
    : this->ExtractLeaf(vtkUnstructuredGrid::GetData(in[0]), "", byTime ? &time : nullptr,
        vtkPolyData::SafeDownCast(output));
  return good ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkExtractCarvedLOD::ExtractTree(
  vtkDataObject* tree, const std::string& where, const double* time, vtkMultiBlockDataSet* levels)
{
  std::vector<CompositeChild> children;
  if (!GetChildren(tree, children))
  {
    vtkErrorMacro(<< where << "A " << tree->GetClassName() << " is not the stream of a carver.");
    return false;
  }
  levels->SetNumberOfBlocks(static_cast<unsigned int>(children.size()));
  for (unsigned int i = 0; i < children.size(); ++i)
  {
    vtkDataObject* child = children[i].Data;
    const std::string whereChild = children[i].Where(where, i);
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(child))
    {
      vtkNew<vtkPolyData> level;
      // Reports an error; the other leaves go on.
      this->ExtractLeaf(grid, whereChild, time, level);
      levels->SetBlock(i, level);
    }
    else if (child && child->IsA("vtkCompositeDataSet"))
    {
      vtkNew<vtkMultiBlockDataSet> subtree;
      this->ExtractTree(child, whereChild, time, subtree);
      levels->SetBlock(i, subtree);
    }
    else if (child)
    {
      vtkErrorMacro(<< whereChild << "A " << child->GetClassName()
                    << " is not the stream of a carver.");
    }
    SetBlockName(levels, i, children[i].Name);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkExtractCarvedLOD::ExtractLeaf(
  vtkUnstructuredGrid* grid, const std::string& where, const double* time, vtkPolyData* level)
{
  const bool good =
    WithinMemory(this, where, [&] { return this->ExtractLeafUnguarded(grid, where, time, level); });
  if (!good)
  {
    level->Initialize();
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkExtractCarvedLOD::ExtractLeafUnguarded(
  vtkUnstructuredGrid* grid, const std::string& where, const double* time, vtkPolyData* level)
{
  if (grid->GetNumberOfCells() == 0)
  {
    return true; // the stream of an empty input
  }
  PreparedStream& stream = this->Streams->Get(grid);
  if (!stream.Error.empty())
  {
    vtkErrorMacro(<< where << stream.Error);
    return false;
  }
  const bool inPlane = GetStreamDimension(grid) == 2;
  const std::string problem = this->LevelSimplification == ENCLOSING_COLLAPSE && !inPlane
    ? this->ExtractSimplified(grid, stream, time, level)
    : this->ExtractCarved(grid, stream, time, level);
  if (!problem.empty())
  {
    vtkWarningMacro(<< where << problem);
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkExtractCarvedLOD::ExtractCarved(
  vtkUnstructuredGrid* grid, PreparedStream& stream, const double* time, vtkPolyData* level)
{
  const auto type = static_cast<carving::LevelTarget>(this->LevelTargetType);
  const auto [step, problem] = time
    ? carving::SelectedStep{ stream.GetStepOfTime(*time, this->NumberOfTimeSteps), {} }
    : carving::SelectStep(stream.Profile, type, this->LevelTarget);
  if (GetStreamDimension(grid) == 2)
  {
    FillLevel(stream.Plane, stream.Profile, grid, carving::ExtractLevel(stream.Plane, step),
      this->ManifoldOutput, level);
  }
  else
  {
    FillLevel(stream.Space, stream.Profile, grid, carving::ExtractLevel(stream.Space, step),
      this->ManifoldOutput, level);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkExtractCarvedLOD::ExtractSimplified(
  vtkUnstructuredGrid* grid, PreparedStream& stream, const double* time, vtkPolyData* level)
{
  using carving::LevelTarget;
  const carving::Profile& profile = stream.Profile;
  const carving::SimplifiedTarget target = time
    ? carving::MakeSimplifiedTarget(profile, LevelTarget::Vertices,
        profile.Vertices[stream.GetStepOfTime(*time, this->NumberOfTimeSteps)], 0)
    : carving::MakeSimplifiedTarget(profile, static_cast<LevelTarget>(this->LevelTargetType),
        this->LevelTarget, this->MaximumVertices);
  return target.Problem +
    FillSimplifiedLevel(
      stream.Space, stream.Simplified, profile, grid, target, this->ManifoldOutput, level);
}

//------------------------------------------------------------------------------
void vtkExtractCarvedLOD::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LevelTargetType: "
     << carving::LevelTargetName(static_cast<carving::LevelTarget>(this->LevelTargetType)) << "\n";
  os << indent << "LevelTarget: " << this->LevelTarget << "\n";
  os << indent << "LevelSimplification: "
     << (this->LevelSimplification == SUBSET ? "SUBSET" : "ENCLOSING_COLLAPSE") << "\n";
  os << indent << "MaximumVertices: " << this->MaximumVertices << "\n";
  os << indent << "ManifoldOutput: " << (this->ManifoldOutput ? "On" : "Off") << "\n";
  os << indent << "FollowTime: " << (this->FollowTime ? "On" : "Off") << "\n";
  os << indent << "NumberOfTimeSteps: " << this->NumberOfTimeSteps << "\n";
}
