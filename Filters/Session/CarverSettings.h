// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The properties of a carver, in the form that the session uses.
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

/** The properties of the filter on which an update depends. */
struct CarverSettings : HelperSettings
{
  bool AppendInput = false;
  carving::CarveOptions Carve;
  bool DepthIsDistance = false; ///< the distance from C0, else the depth in the hierarchy
  bool ComputeError = false;    ///< also if no target needs the errors
  int NumberOfLevels = 8;
  std::vector<double> LevelTargets; ///< replace NumberOfLevels unless empty
  carving::LevelTarget TargetType = carving::LevelTarget::Vertices;
  carving::FoldSides Folds = carving::FoldSides::One;
  bool ManifoldOutput = true;
  int NumberOfThreads = 1; ///< the most helper programs at a time
  int ThreadsOfLeaf = 1;   ///< that work on one leaf
  bool Simplify = false;   ///< whether levels are decimated
  /** The most vertices of a simplified level whose target is no number of them; 0: no limit. */
  int MaximumVertices = 0;
  /** The properties that a stream stores, by their names. */
  vtkSmartPointer<vtkFieldData> Stored;
};

#endif
