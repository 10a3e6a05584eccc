// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From simplified levels to the field data of the stored stream, and back. vtkTopologyCarver.h
 * documents the arrays.
 */
#ifndef SimplifiedOutput_h
#define SimplifiedOutput_h

#include "Core/Measure/Profile.h"
#include "Core/Measure/SimplifiedStream.h"

class ArrayReader;
class vtkFieldData;
class vtkUnstructuredGrid;

/** Adds the arrays, unless there is no simplified level. */
void FillSimplifiedStream(const carving::SimplifiedStream& stream, vtkFieldData* fieldData);

/** Reads and checks the arrays, if there are any. */
void ReadSimplifiedStream(vtkUnstructuredGrid* grid, const carving::Profile& profile,
  ArrayReader& reader, carving::SimplifiedStream& stream);

#endif
