// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a stored stream to the data objects of the output ports 1 and 2. vtkTopologyCarver.h
 * documents the arrays.
 */
#ifndef StreamOutput_h
#define StreamOutput_h

#include "Convert/ArrayNames.h"
#include "Core/Measure/Profile.h"
#include "Core/Stream/StoredStream.h"
#include "vtkType.h"

#include <vector>

class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

/**
 * Fills the grid with a stream. `cellIds` has the cell of `input` for each facet that the helper
 * program was given. The field data get the profile and the settings that are members of the
 * stream; the caller adds the other settings.
 */
template <int D>
void FillStream(const carving::StoredStream<D>& stream, const carving::Profile& profile,
  vtkPolyData* input, const std::vector<vtkIdType>& cellIds, vtkUnstructuredGrid* output);

void FillProfile(const carving::Profile& profile, vtkTable* output);

#endif
