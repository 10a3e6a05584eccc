// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Arrays of the input that have the names of arrays that the carvers write.
 */
#ifndef OwnArrays_h
#define OwnArrays_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

/**
 * Renames cell and point arrays whose names the outputs use, and adds a note about them. Returns
 * the input itself if it has no such arrays, else a copy that shares all other data with the input.
 */
vtkSmartPointer<vtkPolyData> RenameForeignArrays(
  vtkPolyData* input, std::vector<std::string>& notes);

/**
 * Removes the field data that a carving writes, including the arrays that have the names of
 * `settings`. After an older carving, such data no longer holds.
 */
void RemoveOwnFieldData(vtkFieldData* fieldData, vtkFieldData* settings);

#endif
