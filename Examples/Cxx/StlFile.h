// SPDX-License-Identifier: BSD-3-Clause
#ifndef StlFile_h
#define StlFile_h

#include <string>

/** Stereolithography files (STL) that VTK's reader takes for whole although they are not. */
namespace StlFile
{

/**
 * Describes a binary file that ends before its last triangle. Returns an empty string for a whole
 * file, and for a text file.
 */
std::string FindMistake(const std::string& fileName);

} // namespace StlFile

#endif
