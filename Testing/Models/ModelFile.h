// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes models to files without loss of precision.
 */
#ifndef ModelFile_h
#define ModelFile_h

#include "Contours.h"
#include "Core/Mesh/Mesh.h"

#include <string>

namespace models
{

/** Writes binary PLY or OFF, by the extension of the name. Returns an empty string or an error. */
std::string Write(const std::string& fileName, const carving::TriangleMesh& mesh);

/** Writes lines in VTK's legacy format (.vtk). Returns an empty string or an error. */
std::string Write(const std::string& fileName, const ContourModel& contour);

} // namespace models

#endif
