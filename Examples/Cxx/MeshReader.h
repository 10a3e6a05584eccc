// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshReader_h
#define MeshReader_h

#include <string>
#include <vector>

class ErrorLog;
class vtkPolyData;

/** The required content of a file. */
enum class Wanted
{
  Polygons,
  Contours ///< polygons or lines
};

/** Returns an empty string, or the reason why a file cannot be read at all. */
std::string CheckFile(const std::string& fileName);

/** Returns an empty string, or the reason why there is nothing to carve in the meshes of a file. */
std::string CheckCells(const std::vector<vtkPolyData*>& meshes, Wanted wanted);

/**
 * Reads a polygonal mesh or contours. The end of the name determines the format: .obj, .ply, .stl,
 * .off, .vtp, .vtk (legacy), each also with .gz. Returns an empty string, or the reason for a
 * failure in one line. `log` collects the errors of VTK's readers.
 */
std::string ReadMesh(const std::string& fileName, Wanted wanted, ErrorLog* log, vtkPolyData* mesh);

#endif
