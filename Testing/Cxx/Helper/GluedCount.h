// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Components of tetrahedra that are glued at faces, counted independently of the code under test.
 */
#ifndef GluedCount_h
#define GluedCount_h

#include "Core/Carving/Carver.h"
#include "Core/Mesh/Mesh.h"

/**
 * The number of components of the tetrahedra that remain after a step, glued at faces only; in
 * linear time.
 */
int CountGlued(const carving::Tetrahedralization& mesh, const carving::Stream& stream, int step);

#endif
