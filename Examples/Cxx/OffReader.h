// SPDX-License-Identifier: BSD-3-Clause
#ifndef OffReader_h
#define OffReader_h

#include <string>

class vtkPolyData;

/**
 * Reads an ASCII Object File Format mesh (OFF), whose points become doubles. Colors, normals and
 * texture coordinates (COFF, NOFF, STOFF, ...) are passed over. Returns an empty string or what is
 * wrong with the file.
 */
std::string ReadOff(const std::string& fileName, vtkPolyData* mesh);

#endif
