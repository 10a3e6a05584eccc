// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From the field data of a stream back to a profile.
 */
#ifndef ProfileInput_h
#define ProfileInput_h

#include "Convert/ArrayReader.h"
#include "Core/Measure/Profile.h"

#include <string>

class vtkUnstructuredGrid;

/** 2 for a stream of triangles, 3 for one of tetrahedra and for any other grid. */
int GetStreamDimension(vtkUnstructuredGrid* grid);

/** Reads the profile. Returns an empty string, or a description of the first mistake. */
std::string ReadProfile(vtkUnstructuredGrid* grid, carving::Profile& profile);

/**
 * Reads the profile with a reader that collects mistakes. Returns the measure of its priorities.
 */
carving::PriorityMeasure ReadProfile(
  vtkUnstructuredGrid* grid, ArrayReader& reader, carving::Profile& profile);

#endif
