// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From the unstructured grid of port 1 back to a stored stream.
 */
#ifndef StreamInput_h
#define StreamInput_h

#include "Core/Measure/Profile.h"
#include "Core/Stream/StoredStream.h"

#include <string>

class vtkUnstructuredGrid;

/**
 * Fills what levels need; `Mesh.Surface` lacks what only resolving uses. Returns an empty string, or
 * what is wrong with the grid: something else than an unchanged stream.
 */
template <int D>
std::string ReadStream(
  vtkUnstructuredGrid* grid, carving::StoredStream<D>& stream, carving::Profile& profile);

#endif
