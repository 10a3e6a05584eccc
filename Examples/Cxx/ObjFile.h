// SPDX-License-Identifier: BSD-3-Clause
#ifndef ObjFile_h
#define ObjFile_h

#include <ostream>
#include <string>

/** Mistakes in Wavefront files (OBJ) on which VTK's reader crashes or gives up. */
namespace ObjFile
{

/**
 * Describes a face that has fewer than three corners, or refers to texture coordinates or normals
 * that the file does not have, or counts them backward. Returns an empty string if there is none.
 */
std::string FindMistake(const std::string& fileName);

/**
 * Copies a file without its texture coordinates and normals, and without faces of fewer than three
 * corners. Everything else keeps its line.
 */
void CopyWithoutAttributes(const std::string& fileName, std::ostream& out);

} // namespace ObjFile

#endif
