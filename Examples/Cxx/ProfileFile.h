// SPDX-License-Identifier: BSD-3-Clause
#ifndef ProfileFile_h
#define ProfileFile_h

#include <string>

class vtkTable;

namespace ProfileFile
{

/** Whether a chart is written under that name, and not a table. */
bool IsChart(const std::string& fileName);

/** Returns an empty string, or the reason why no file can be written under that name. */
std::string Check(const std::string& fileName);

/**
 * Writes the profile of a carver: to .csv the whole table, to .png a chart of components, tunnels
 * and voids over vertices. Axes are logarithmic if their numbers differ much. Returns an empty
 * string, or an error.
 */
std::string Write(const std::string& fileName, vtkTable* profile, bool contours);

} // namespace ProfileFile

#endif
