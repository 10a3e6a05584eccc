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

class vtkFieldData;
class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

/**
 * Fills the grid with a stream. `cellIds` has the cell of `input` for each facet that the helper
 * program was given. The field data get the settings that are members of the stream; the caller
 * adds the other settings and the profile. The stream's priorities, depths and regions are
 * released: levels do not need them.
 */
template <int D>
void FillStream(carving::StoredStream<D>& stream, vtkPolyData* input,
  const std::vector<vtkIdType>& cellIds, vtkUnstructuredGrid* output);

void FillProfile(const carving::Profile& profile, vtkTable* output);

/** Adds the columns of a profile, with or without the errors, to field data, which share them. */
void AddProfile(vtkTable* profile, bool withErrors, vtkFieldData* fieldData);

#endif
