// SPDX-License-Identifier: BSD-3-Clause
#include "Session/PreparedStreams.h"

#include "Convert/ProfileInput.h"
#include "Convert/StreamInput.h"
#include "Core/Measure/LevelSelection.h"
#include "vtkCompositeDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

int PreparedStream::GetStepOfTime(double time, int numberOfTimes)
{
  if (this->NumberOfTimes != numberOfTimes)
  {
    this->NumberOfTimes = numberOfTimes;
    this->StepsOfTimes = carving::SpreadLevels(this->Profile, numberOfTimes);
  }
  const double last = static_cast<double>(this->StepsOfTimes.size()) - 1.0;
  // fmax ignores a time that is not a number.
  const double fraction = std::min(std::fmax(0.0, time / (numberOfTimes - 1)), 1.0);
  return this->StepsOfTimes[static_cast<std::size_t>(std::lround(fraction * last))];
}

PreparedStream* PreparedStreams::Find(vtkUnstructuredGrid* grid)
{
  this->All.remove_if([](const PreparedStream& stream) { return !stream.Grid.IsCurrent(); });
  const auto found = std::find_if(this->All.begin(), this->All.end(),
    [grid](const PreparedStream& stream) { return stream.Grid.IsOf(grid); });
  return found != this->All.end() ? &*found : nullptr;
}

PreparedStream& PreparedStreams::Get(vtkUnstructuredGrid* grid)
{
  if (PreparedStream* found = this->Find(grid))
  {
    return *found;
  }
  PreparedStream& stream = this->All.emplace_back();
  stream.Error = GetStreamDimension(grid) == 2
    ? ReadStream(grid, stream.Plane, stream.Profile, stream.Simplified)
    : ReadStream(grid, stream.Space, stream.Profile, stream.Simplified);
  stream.Grid = DataVersion(grid); // last, since memory may run out before
  return stream;
}

std::vector<carving::Profile> PreparedStreams::GetProfiles(vtkDataObject* input)
{
  std::vector<carving::Profile> profiles;
  for (vtkUnstructuredGrid* grid : vtkCompositeDataSet::GetDataSets<vtkUnstructuredGrid>(input))
  {
    const PreparedStream* stream = this->Find(grid);
    carving::Profile profile;
    if (stream ? stream->Error.empty() : ReadProfile(grid, profile).empty())
    {
      profiles.push_back(stream ? stream->Profile : profile);
    }
  }
  return profiles;
}

std::vector<TargetRange> PreparedStreams::GetTargetRanges(
  vtkDataObject* input, carving::LevelTarget type)
{
  std::vector<TargetRange> ranges;
  for (vtkUnstructuredGrid* grid : vtkCompositeDataSet::GetDataSets<vtkUnstructuredGrid>(input))
  {
    if (TargetRange range; ReadTargetRange(grid->GetFieldData(), type, range))
    {
      ranges.push_back(range);
    }
  }
  return ranges;
}
