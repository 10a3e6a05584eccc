// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes models to files without loss.
 */
#ifndef ModelFile_h
#define ModelFile_h

#include "Contours.h"
#include "Core/Mesh/Mesh.h"

#include <string>

namespace models
{

/** As binary PLY or as OFF, after the end of the name. Returns what went wrong, else an empty string. */
std::string Write(const std::string& fileName, const carving::TriangleMesh& mesh);

/** As lines in VTK's legacy format (.vtk). */
std::string Write(const std::string& fileName, const ContourModel& contour);

} // namespace models

#endif
