// SPDX-License-Identifier: BSD-3-Clause
#ifndef LevelWriter_h
#define LevelWriter_h

#include <string>
#include <vector>

class ErrorLog;
class vtkMultiBlockDataSet;

namespace LevelWriter
{

/**
 * Returns an empty string, or the reason why levels cannot be written in a format, which is an
 * extension in lower case. `where` is the part of the command line that names the format.
 */
std::string CheckFormat(const std::string& extension, const std::string& where);

/** Whether a file of that format can hold the levels of several meshes. */
bool HoldsSeveralMeshes(const std::string& extension);

/** Whether a file of that format can hold lines. */
bool HoldsLines(const std::string& extension);

/**
 * Writes a multiblock of levels, or of multiblocks of levels, to one .vtm, .vtpc or .glb file; or
 * a multiblock of levels to one .vtp, .ply, .obj or .stl file per level. Returns an empty string,
 * or an error. `written` gets the names of the files; `warnings` gets a sentence for each level
 * that crosses itself after rounding to the precision of the format.
 */
std::string Write(const std::string& fileName, vtkMultiBlockDataSet* levels, ErrorLog* log,
  std::vector<std::string>& written, std::vector<std::string>& warnings);

} // namespace LevelWriter

#endif
