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
 * The input as its data is to be passed on: cell and point arrays that have a name of the outputs' own are
 * renamed, for which there is a note. The input itself where there are none, else a copy that shares the
 * rest with it.
 */
vtkSmartPointer<vtkPolyData> RenameForeignArrays(
  vtkPolyData* input, std::vector<std::string>& notes);

/** Removes what a carving writes itself: settings and measures of an older one say nothing of this one. */
void RemoveOwnFieldData(vtkFieldData* fieldData);

#endif
