// SPDX-License-Identifier: BSD-3-Clause
#ifndef ObjFile_h
#define ObjFile_h

#include <ostream>
#include <string>

/** Wavefront files (OBJ) that VTK's reader misreads, or on which it crashes or gives up. */
namespace ObjFile
{

struct Content
{
  /**
   * Describes a face that has fewer than three corners, or refers to texture coordinates or normals
   * that the file does not have, or counts them backward. Empty if there is none.
   */
  std::string Mistake;
  /** Whether the file has a byte order mark, comments behind other words, or continued lines. */
  bool IsUnusual = false;
};

Content Check(const std::string& fileName);

/** Copies a file without a byte order mark and such comments, with continued lines joined. */
void Copy(const std::string& fileName, std::ostream& out);

/**
 * The same without texture coordinates and normals, and without faces of fewer than three corners.
 */
void CopyWithoutAttributes(const std::string& fileName, std::ostream& out);

} // namespace ObjFile

#endif
