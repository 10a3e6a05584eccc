// SPDX-License-Identifier: BSD-3-Clause
#ifndef LevelWriter_h
#define LevelWriter_h

#include <string>
#include <vector>

class ErrorLog;
class vtkMultiBlockDataSet;

namespace LevelWriter
{

/** Returns an empty string or why levels cannot be written under that name. */
std::string CheckName(const std::string& fileName);

/**
 * Writes a multiblock of levels into one .vtm file, or a file per level for .vtp, .ply, .obj, .stl.
 * Returns an empty string or what went wrong. `written` gets the names of the files to look at,
 * `warnings` what rounding to the format's precision did to the levels.
 */
std::string Write(const std::string& fileName, vtkMultiBlockDataSet* levels, ErrorLog* log,
  std::vector<std::string>& written, std::vector<std::string>& warnings);

} // namespace LevelWriter

#endif
