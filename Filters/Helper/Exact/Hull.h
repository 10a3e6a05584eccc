// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Hull_h
#define carving_Hull_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/**
 * Whether the volumes of the tetrahedra add up to the volume of the convex hull of all points,
 * except for rounding. If not, tetrahedra are missing or overlap. The hull is that of all points
 * that are not surrounded by tetrahedra.
 */
bool FillsHull(const Tetrahedralization& mesh);

} // namespace carving::helper

#endif
