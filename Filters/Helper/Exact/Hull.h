// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Hull_h
#define carving_Hull_h

#include "Core/Mesh/Mesh.h"

/**
 * Whether the volumes of the tetrahedra add up to that of the convex hull of all points, up to rounding: if
 * not, some are missing or overlap. The hull is computed apart from them.
 */
bool FillHull(const carving::Tetrahedralization& mesh);

#endif
