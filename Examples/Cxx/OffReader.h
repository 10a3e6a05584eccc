// SPDX-License-Identifier: BSD-3-Clause
#ifndef OffReader_h
#define OffReader_h

#include <array>
#include <string>
#include <vector>

struct OffMesh
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::vector<int>> Faces;
};

/**
 * Reads an ASCII Object File Format mesh (OFF). Colors, normals and texture coordinates (COFF,
 * NOFF, STOFF, ...) are ignored. Returns an empty string, or the mistake in the file.
 */
std::string ReadOff(const std::string& fileName, OffMesh& mesh);

#endif
