// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshReader_h
#define MeshReader_h

#include <string>

class ErrorLog;
class vtkPolyData;

/** What a file must hold. */
enum class Wanted
{
  Polygons,
  Contours ///< polygons or lines
};

/**
 * Reads a polygonal mesh or contours; the end of the name tells its format: .obj, .ply, .stl, .off, .vtp, .vtk
 * (legacy), each also with .gz. Returns an empty string or why it cannot be read, in one line.
 * `log` is where VTK's readers complain to.
 */
std::string ReadMesh(const std::string& fileName, Wanted wanted, ErrorLog* log, vtkPolyData* mesh);

#endif
