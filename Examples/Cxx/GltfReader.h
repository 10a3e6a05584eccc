// SPDX-License-Identifier: BSD-3-Clause
#ifndef GltfReader_h
#define GltfReader_h

#include <string>

class ErrorLog;
class vtkMultiBlockDataSet;

namespace GltfReader
{

/**
 * Reads a .gltf or .glb file. `meshes` gets a block for each node that has a mesh, with all parts
 * of the mesh, placed as the scene places it. Its name consists of the names of the nodes from the
 * root on, with / between them. Returns an empty string, or an error.
 */
std::string Read(const std::string& fileName, ErrorLog* log, vtkMultiBlockDataSet* meshes);

} // namespace GltfReader

#endif
