// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlyFile_h
#define PlyFile_h

#include <string>

/** Polygon files (PLY) that VTK's reader misreads. */
namespace PlyFile
{

/**
 * Describes elements before the faces that are no vertices: VTK's reader does not skip them and
 * takes their lines for faces. Returns an empty string if there are none.
 */
std::string FindMistake(const std::string& fileName);

/** Whether a file is text and lacks its last line feed. VTK's reader crashes on such a file. */
bool EndsWithinALine(const std::string& fileName);

} // namespace PlyFile

#endif
