// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExtractCarvedLOD.h"

#include "LevelOutput.h"
#include "LevelSelection.h"
#include "StreamInput.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <numeric>
#include <vector>

namespace
{

/** A stream that has been read from a grid. */
struct Prepared
{
  vtkWeakPointer<vtkUnstructuredGrid> Grid;
  vtkMTimeType Time = 0;
  std::string Error;
  carving::Profile Profile;
  // One of them, by the stream's dimension.
  carving::StoredStream<3> Space;
  carving::StoredStream<2> Plane;
  /** The steps of the levels that stand for so many times. */
  int NumberOfTimes = 0;
  std::vector<int> StepsOfTimes;
};

/** The step for a time; where there are fewer levels than times, some show twice. */
int StepOfTime(Prepared& stream, double time, int numberOfTimes)
{
  if (stream.NumberOfTimes != numberOfTimes)
  {
    stream.NumberOfTimes = numberOfTimes;
    stream.StepsOfTimes = carving::SpreadLevels(stream.Profile, numberOfTimes);
  }
  const double last = static_cast<double>(stream.StepsOfTimes.size()) - 1.0;
  const double fraction = std::clamp(time / (numberOfTimes - 1), 0.0, 1.0);
  return stream.StepsOfTimes[static_cast<std::size_t>(std::lround(fraction * last))];
}

} // namespace

/** The streams of all inputs that are alive: a composite has many. */
class vtkExtractCarvedLOD::Internals
{
public:
  Prepared& Get(vtkUnstructuredGrid* grid)
  {
    this->All.remove_if([](const Prepared& stream)
      { return !stream.Grid || stream.Grid->GetMTime() != stream.Time; });
    const auto found = std::find_if(this->All.begin(), this->All.end(),
      [grid](const Prepared& stream) { return stream.Grid == grid; });
    if (found != this->All.end())
    {
      return *found;
    }
    Prepared& stream = this->All.emplace_back();
    stream.Grid = grid;
    stream.Time = grid->GetMTime();
    stream.Error = GetStreamDimension(grid) == 2 ? ReadStream(grid, stream.Plane, stream.Profile)
                                                 : ReadStream(grid, stream.Space, stream.Profile);
    return stream;
  }

private:
  std::list<Prepared> All;
};

vtkStandardNewMacro(vtkExtractCarvedLOD);

//------------------------------------------------------------------------------
vtkExtractCarvedLOD::vtkExtractCarvedLOD()
  : Streams(new Internals)
{
}

//------------------------------------------------------------------------------
vtkExtractCarvedLOD::~vtkExtractCarvedLOD() = default;

//------------------------------------------------------------------------------
void vtkExtractCarvedLOD::SetLevelTargetType(int type)
{
  const int known = static_cast<int>(carving::ToLevelTarget(type));
  if (this->LevelTargetType != known)
  {
    this->LevelTargetType = known;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkExtractCarvedLOD::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
bool vtkExtractCarvedLOD::OfferTimes(vtkInformation* input, vtkInformation* output)
{
  using vtkSDDP = vtkStreamingDemandDrivenPipeline;
  // Some readers give a single time step to what does not change.
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
bool vtkExtractCarvedLOD::GetLevelTargetRange(int type, double range[2])
{
  range[0] = range[1] = 0.0;
  bool found = false;
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  for (vtkUnstructuredGrid* grid : vtkCompositeDataSet::GetDataSets<vtkUnstructuredGrid>(input))
  {
    carving::Profile profile;
    if (ReadProfile(grid, profile).empty())
    {
      const auto [least, greatest] = carving::GetTargetRange(profile, carving::ToLevelTarget(type));
      range[0] = found ? std::min(range[0], least) : least;
      range[1] = found ? std::max(range[1], greatest) : greatest;
      found = true;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
int vtkExtractCarvedLOD::RequestData(
  vtkInformation*, vtkInformationVector** in, vtkInformationVector* out)
{
  auto* grid = vtkUnstructuredGrid::GetData(in[0]);
  auto* output = vtkPolyData::GetData(out);
  output->GetFieldData()->Initialize(); // the pipeline has passed the stream's
  if (grid->GetNumberOfCells() == 0)
  {
    return 1; // the stream of nothing
  }
  Prepared& stream = this->Streams->Get(grid);
  if (!stream.Error.empty())
  {
    vtkErrorMacro(<< stream.Error);
    return 0;
  }
  using vtkSDDP = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = out->GetInformationObject(0);
  carving::SelectedStep selected;
  if (this->OffersTime && outInfo->Has(vtkSDDP::UPDATE_TIME_STEP()))
  {
    const double time = outInfo->Get(vtkSDDP::UPDATE_TIME_STEP());
    selected.Step = StepOfTime(stream, time, this->NumberOfTimeSteps);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
  else
  {
    selected = carving::SelectStep(
      stream.Profile, carving::ToLevelTarget(this->LevelTargetType), this->LevelTarget);
  }
  if (!selected.Problem.empty())
  {
    vtkWarningMacro(<< selected.Problem);
  }
  if (GetStreamDimension(grid) == 2)
  {
    FillLevel(stream.Plane, stream.Profile, grid, selected.Step, this->ManifoldOutput, output);
  }
  else
  {
    FillLevel(stream.Space, stream.Profile, grid, selected.Step, this->ManifoldOutput, output);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkExtractCarvedLOD::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LevelTargetType: "
     << carving::LevelTargetName(static_cast<carving::LevelTarget>(this->LevelTargetType)) << "\n";
  os << indent << "LevelTarget: " << this->LevelTarget << "\n";
  os << indent << "ManifoldOutput: " << (this->ManifoldOutput ? "On" : "Off") << "\n";
  os << indent << "FollowTime: " << (this->FollowTime ? "On" : "Off") << "\n";
  os << indent << "NumberOfTimeSteps: " << this->NumberOfTimeSteps << "\n";
}
