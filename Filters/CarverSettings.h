// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The properties of a carver as its parts pass them on.
 */
#ifndef CarverSettings_h
#define CarverSettings_h

#include "Carver.h"
#include "Classification.h"
#include "LevelSelection.h"
#include "Protocol.h"

#include <vector>

/** The properties of the filter that an update depends on. */
struct CarverSettings : carving::HelperOptions
{
  bool AppendInput = false;
  carving::SolidRule Solid = carving::SolidRule::NonzeroWinding;
  carving::CarveOptions Carve;
  bool DepthIsDistance = false; ///< from C0, instead of the level in the hierarchy
  bool ComputeError = false;    ///< without that a target asks for it
  int NumberOfLevels = 8;
  std::vector<double> LevelTargets; ///< replace NumberOfLevels if there are any
  carving::LevelTarget TargetType = carving::LevelTarget::Vertices;
  bool KeepBothFoldSides = false;
  bool ManifoldOutput = true;
};

#endif
