// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Streams that have been read from grids, kept between requests for levels.
 */
#ifndef PreparedStreams_h
#define PreparedStreams_h

#include "Convert/TargetRanges.h"
#include "Core/Measure/Profile.h"
#include "Core/Measure/SimplifiedStream.h"
#include "Core/Stream/StoredStream.h"
#include "Objects/DataVersion.h"

#include <list>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

/** A stream that has been read from a grid. */
struct PreparedStream
{
  DataVersion Grid;
  std::string Error; ///< empty if the grid is a stream
  carving::Profile Profile;
  carving::StoredStream<3> Space; ///< for a stream of tetrahedra
  carving::StoredStream<2> Plane; ///< for a stream of triangles
  carving::SimplifiedStream Simplified;

  /** The step of the level for a time from 0 to `numberOfTimes` - 1. */
  int GetStepOfTime(double time, int numberOfTimes);

private:
  int NumberOfTimes = 0;
  std::vector<int> StepsOfTimes; ///< at most one for each time
};

/**
 * The streams of the leaves of an input. Streams whose grids have changed or vanished are dropped.
 */
class PreparedStreams
{
public:
  /** Reads the grid, unless that has been done before. */
  PreparedStream& Get(vtkUnstructuredGrid* grid);

  /** The profiles of all streams in a data object, which can be null. No stream is read in full. */
  std::vector<carving::Profile> GetProfiles(vtkDataObject* input);

  /**
   * The ranges of targets of all streams in a data object, which can be null, on whatever process
   * the streams are.
   */
  static std::vector<TargetRange> GetTargetRanges(vtkDataObject* input, carving::LevelTarget type);

private:
  /** Returns null if the grid has not been read in its present state. */
  PreparedStream* Find(vtkUnstructuredGrid* grid);

  std::list<PreparedStream> All;
};

#endif
