// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/TargetRanges.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayReader.h"
#include "Convert/ArrayTools.h"
#include "vtkDoubleArray.h"

#include <algorithm>
#include <cmath>

namespace
{

constexpr int Components = 3; // the members of a range

} // namespace

TargetRange GetTargetRange(const carving::Profile& profile,
  const carving::SimplifiedStream& simplified, carving::LevelTarget type)
{
  const auto [least, greatest] = carving::GetTargetRange(profile, type);
  const double leastSimplified = carving::FindLeastTarget(simplified, type);
  // An error bound that no simplified level meets gets a step as carved.
  const bool mayBeCarved = type == carving::LevelTarget::ErrorBound && !profile.Error.empty();
  const double leastOfAll = mayBeCarved ? std::min(least, leastSimplified) : leastSimplified;
  return { least, greatest, std::isfinite(leastSimplified) ? leastOfAll : least };
}

void AddTargetRanges(const carving::Profile& profile, const carving::SimplifiedStream& simplified,
  vtkFieldData* fieldData)
{
  std::vector<double> values;
  for (int type = 0; type < carving::NumberOfLevelTargets; ++type)
  {
    const auto [least, greatest, leastSimplified] =
      GetTargetRange(profile, simplified, static_cast<carving::LevelTarget>(type));
    values.insert(values.end(), { least, greatest, leastSimplified });
  }
  AddTargetRanges(values, fieldData);
}

void AddTargetRanges(const std::vector<double>& values, vtkFieldData* fieldData)
{
  auto ranges = MakeArray<vtkDoubleArray>(
    StreamArrays::TargetRanges, static_cast<vtkIdType>(values.size()) / Components, Components);
  std::copy(values.begin(), values.end(), ranges->GetPointer(0));
  fieldData->AddArray(ranges);
}

std::vector<double> ReadTargetRanges(vtkFieldData* fieldData)
{
  ArrayReader reader;
  std::vector<double> values;
  reader.Read(fieldData, StreamArrays::TargetRanges, carving::NumberOfLevelTargets,
    FiniteMeasures(), values, Components);
  return values;
}

bool ReadTargetRange(vtkFieldData* fieldData, carving::LevelTarget type, TargetRange& range)
{
  const std::vector<double> values = ReadTargetRanges(fieldData);
  if (values.empty())
  {
    return false;
  }
  const double* const ofType = &values[Components * static_cast<std::size_t>(type)];
  range = { ofType[0], ofType[1], ofType[2] };
  return true;
}
