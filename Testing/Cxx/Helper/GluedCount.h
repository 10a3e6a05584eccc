// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Components of tetrahedra that are glued at faces, by other means than those of the code under test.
 */
#ifndef GluedCount_h
#define GluedCount_h

#include "Core/Carving/Carver.h"
#include "Core/Mesh/Mesh.h"

/** How many components the tetrahedra that are left have, glued at faces only; counted from scratch. */
int CountGlued(const carving::Tetrahedralization& mesh, const carving::Stream& stream, int step);

#endif
