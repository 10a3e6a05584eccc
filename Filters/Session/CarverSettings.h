// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The properties of a carver as its parts pass them on.
 */
#ifndef CarverSettings_h
#define CarverSettings_h

#include "Core/Carving/Carver.h"
#include "Core/Measure/LevelSelection.h"
#include "Core/Stream/StoredStream.h"
#include "Session/HelperReuse.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"

#include <vector>

/** The properties of the filter that an update depends on. */
struct CarverSettings : HelperSettings
{
  bool AppendInput = false;
  carving::CarveOptions Carve;
  bool DepthIsDistance = false; ///< from C0, instead of the level in the hierarchy
  bool ComputeError = false;    ///< without that a target asks for it
  int NumberOfLevels = 8;
  std::vector<double> LevelTargets; ///< replace NumberOfLevels if there are any
  carving::LevelTarget TargetType = carving::LevelTarget::Vertices;
  carving::FoldSides Folds = carving::FoldSides::One;
  bool ManifoldOutput = true;
  /** The properties that a stream stores, by their names. */
  vtkSmartPointer<vtkFieldData> Stored;
};

#endif
