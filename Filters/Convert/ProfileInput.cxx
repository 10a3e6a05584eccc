// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/ProfileInput.h"

#include "Convert/ArrayNames.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace
{

/** An array with a count for each step, and the least valid count. */
struct CountArray
{
  const char* Name;
  int Least;
  std::vector<int> carving::Profile::*Counts;
};

constexpr CountArray CountArrays[] = {
  { StreamArrays::ProfileVertices, 0, &carving::Profile::Vertices },
  { StreamArrays::ProfileTriangles, 0, &carving::Profile::Triangles },
  { StreamArrays::ProfileComponents, 1, &carving::Profile::Components },
  { StreamArrays::ProfileTunnels, 0, &carving::Profile::Tunnels },
  { StreamArrays::ProfileVoids, 0, &carving::Profile::Voids },
};

/** The number of entries of every array: the length of the first array that is read. */
vtkIdType CountSteps(vtkFieldData* fieldData)
{
  vtkAbstractArray* priorities = fieldData->GetAbstractArray(StreamArrays::ProfilePriority);
  return std::clamp<vtkIdType>(priorities ? priorities->GetNumberOfTuples() : 0, 1, VTK_INT_MAX);
}

/** Finite numbers that are not negative, each no greater than the one before. */
Demand FallingMeasures()
{
  return { "a finite number of at least 0 that is no greater than the one before",
    [before = std::numeric_limits<double>::max()](double value, vtkIdType) mutable
    {
      const bool isMet = value >= 0.0 && value <= before;
      before = value;
      return isMet;
    } };
}

} // namespace

int GetStreamDimension(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  const vtkIdType count = types ? types->GetNumberOfValues() : 0;
  return count > 0 && types->GetValue(count - 1) == VTK_LINE ? 2 : 3; // the facets of M come last
}

carving::PriorityMeasure ReadProfile(
  vtkUnstructuredGrid* grid, ArrayReader& reader, carving::Profile& profile)
{
  vtkFieldData* fieldData = grid->GetFieldData();
  const vtkIdType steps = CountSteps(fieldData);
  std::vector<double> priorities;
  reader.Read(fieldData, StreamArrays::ProfilePriority, steps,
    Priorities([](vtkIdType step) { return step > 0; }), priorities);
  std::vector<int> measures;
  reader.Read(fieldData, StreamArrays::Measure, 1, IntegersFrom(0, 4), measures);
  for (const auto& [name, least, counts] : CountArrays)
  {
    reader.Read(fieldData, name, steps, IntegersFrom(least), profile.*counts);
  }
  reader.Read(fieldData, StreamArrays::ProfileVolume, steps, FallingMeasures(), profile.Volume);
  if (fieldData->HasArray(StreamArrays::ProfileError))
  {
    reader.Read(fieldData, StreamArrays::ProfileError, steps, FiniteMeasures(), profile.Error);
  }
  const auto measure = static_cast<carving::PriorityMeasure>(measures.empty() ? 0 : measures[0]);
  if (GetStreamDimension(grid) == 2)
  {
    carving::SetPriorities<2>(profile, priorities, measure);
  }
  else
  {
    carving::SetPriorities<3>(profile, priorities, measure);
  }
  return measure;
}

std::string ReadProfile(vtkUnstructuredGrid* grid, carving::Profile& profile)
{
  ArrayReader reader;
  ReadProfile(grid, reader, profile);
  return reader.GetMistake();
}
