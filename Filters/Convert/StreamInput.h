// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From the unstructured grid of output port 1 back to a stored stream.
 */
#ifndef StreamInput_h
#define StreamInput_h

#include "Core/Measure/Profile.h"
#include "Core/Measure/SimplifiedStream.h"
#include "Core/Stream/StoredStream.h"

#include <string>

class vtkUnstructuredGrid;

/**
 * Reads all that levels need. Other members of the stream stay empty: the priorities, the depths,
 * the regions, and members of `Mesh.Surface` that only resolving uses. `simplified` stays empty
 * unless the grid has simplified levels. Returns an empty string, or the first reason why the grid
 * is not an unchanged stream.
 */
template <int D>
std::string ReadStream(vtkUnstructuredGrid* grid, carving::StoredStream<D>& stream,
  carving::Profile& profile, carving::SimplifiedStream& simplified);

#endif
