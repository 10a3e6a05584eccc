// SPDX-License-Identifier: BSD-3-Clause
#ifndef LevelWriter_h
#define LevelWriter_h

#include <string>
#include <vector>

class ErrorLog;
class vtkMultiBlockDataSet;

namespace LevelWriter
{

/** Returns an empty string, or the reason why levels cannot be written under that name. */
std::string CheckName(const std::string& fileName);

/**
 * Writes a multiblock of levels to one .vtm file, or one .vtp, .ply, .obj or .stl file per level.
 * Returns an empty string, or an error. `written` gets the names of the files; `warnings` gets a
 * sentence for each level that crosses itself after rounding to the precision of the format.
 */
std::string Write(const std::string& fileName, vtkMultiBlockDataSet* levels, ErrorLog* log,
  std::vector<std::string>& written, std::vector<std::string>& warnings);

} // namespace LevelWriter

#endif
