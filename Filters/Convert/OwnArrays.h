// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Arrays of the input that cannot be passed on as they are.
 */
#ifndef OwnArrays_h
#define OwnArrays_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

/**
 * Renames cell and point arrays whose names the outputs use, and removes arrays whose length is not
 * the number of cells or points (VTK 9.1 reads OBJ files with lines so). Adds a note about either.
 * Returns the input itself if all arrays can stay, else a copy that shares all other data with the
 * input.
 */
vtkSmartPointer<vtkPolyData> WithUsableArrays(vtkPolyData* input, std::vector<std::string>& notes);

/**
 * Removes the field data that a carving writes, including the arrays that have the names of
 * `settings`. After an older carving, such data no longer holds.
 */
void RemoveOwnFieldData(vtkFieldData* fieldData, vtkFieldData* settings);

#endif
