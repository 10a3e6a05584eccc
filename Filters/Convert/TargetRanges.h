// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The ranges of level targets, in the field data of the stored stream. vtkTopologyCarver.h
 * documents the array. Processes that do not have the stream know its ranges by this array alone.
 */
#ifndef TargetRanges_h
#define TargetRanges_h

#include "Core/Measure/LevelSelection.h"
#include "Core/Measure/SimplifiedStream.h"

#include <vector>

class vtkFieldData;

/** The targets of a type that select different levels of a stream. */
struct TargetRange
{
  double Least;
  double Greatest;
  double LeastSimplified; ///< `Least` of simplified levels, or the same if there are none
};

TargetRange GetTargetRange(const carving::Profile& profile,
  const carving::SimplifiedStream& simplified, carving::LevelTarget type);

void AddTargetRanges(const carving::Profile& profile, const carving::SimplifiedStream& simplified,
  vtkFieldData* fieldData);

/** Adds the array with these values, type by type. */
void AddTargetRanges(const std::vector<double>& values, vtkFieldData* fieldData);

/** Returns the values of the array, or nothing if there is no valid one. */
std::vector<double> ReadTargetRanges(vtkFieldData* fieldData);

/** Returns false if there is no valid array. */
bool ReadTargetRange(vtkFieldData* fieldData, carving::LevelTarget type, TargetRange& range);

#endif
