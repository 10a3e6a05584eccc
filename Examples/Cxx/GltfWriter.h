// SPDX-License-Identifier: BSD-3-Clause
#ifndef GltfWriter_h
#define GltfWriter_h

#include <string>

class vtkMultiBlockDataSet;

namespace GltfWriter
{

/**
 * Writes a tree of surfaces to a binary glTF 2.0 file (.glb): a node with the name of its block
 * for each, with normals, and with the numbers of the level as extras. Returns an empty string, or
 * the reason for a failure. vtkGLTFWriter of VTK 9.1 writes neither .glb files nor names.
 */
std::string Write(const std::string& fileName, vtkMultiBlockDataSet* tree);

} // namespace GltfWriter

#endif
