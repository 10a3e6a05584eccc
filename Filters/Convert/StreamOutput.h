// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a stored stream to the data objects of the ports 1 and 2. The filters' headers document their
 * arrays.
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
 * `cellIds` has the cell of `input` for every facet that the helper program was given. The field data
 * gets the profile and what the stream says of itself; the caller adds the other settings.
 */
template <int D>
void FillStream(const carving::StoredStream<D>& stream, const carving::Profile& profile,
  vtkPolyData* input, const std::vector<vtkIdType>& cellIds, vtkUnstructuredGrid* output);

void FillProfile(const carving::Profile& profile, vtkTable* output);

#endif
