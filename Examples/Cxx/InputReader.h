// SPDX-License-Identifier: BSD-3-Clause
#ifndef InputReader_h
#define InputReader_h

#include "MeshReader.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

/**
 * Reads a mesh or contours as ReadMesh does, or several of them from a .vtm, .vtpc, .glb or .gltf
 * file. `input` is a vtkPolyData, or for several ones a vtkMultiBlockDataSet with a named block
 * for each. Returns an empty string, or the reason for a failure in one line.
 */
std::string ReadInput(
  const std::string& fileName, Wanted wanted, ErrorLog* log, vtkSmartPointer<vtkDataObject>& input);

#endif
