// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The parts of a closed surface where the solid is a sheet without thickness.
 */
#ifndef carving_Sheets_h
#define carving_Sheets_h

#include "Helper/Decimation/SurfaceMesh.h"

#include <vector>

namespace carving::helper
{

/**
 * Per face: whether the face is a side of a sheet. The other side is a face with the same corners
 * the other way round, and the exterior lies in front of both. Where solids touch in such a pair,
 * each face has the other's solid in front of it, and is not a side of a sheet.
 */
std::vector<char> FindSheets(const SurfaceMesh& surface);

} // namespace carving::helper

#endif
