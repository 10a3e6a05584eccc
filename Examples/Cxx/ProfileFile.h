// SPDX-License-Identifier: BSD-3-Clause
#ifndef ProfileFile_h
#define ProfileFile_h

#include <string>

class vtkTable;

namespace ProfileFile
{

/** Returns an empty string, or why nothing can be written there. */
std::string Check(const std::string& fileName);

/**
 * Writes a carver's profile, to .csv all of it, to .png a chart of components, tunnels and voids over
 * vertices; axes are logarithmic where numbers differ much. Returns an empty string or what went wrong.
 */
std::string Write(const std::string& fileName, vtkTable* profile, bool contours);

} // namespace ProfileFile

#endif
