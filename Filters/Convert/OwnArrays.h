// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What becomes of arrays of the input whose names the carver's outputs use.
 */
#ifndef OwnArrays_h
#define OwnArrays_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

/**
 * Renames cell and point arrays that have a name of the outputs' own, and adds a note about them. Returns
 * the input itself if it has no such arrays, else a copy that shares all other data with it.
 */
vtkSmartPointer<vtkPolyData> RenameForeignArrays(
  vtkPolyData* input, std::vector<std::string>& notes);

/** Removes what a carving writes itself: the settings and measures of an older carving no longer hold. */
void RemoveOwnFieldData(vtkFieldData* fieldData);

#endif
