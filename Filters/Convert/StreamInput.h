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
 * Reads all that levels need. `simplified` stays empty unless the grid has simplified levels, and
 * so do members of `Mesh.Surface` that only resolving uses. Returns an empty string, or the first
 * reason why the grid is not an unchanged stream.
 */
template <int D>
std::string ReadStream(vtkUnstructuredGrid* grid, carving::StoredStream<D>& stream,
  carving::Profile& profile, carving::SimplifiedStream& simplified);

#endif
