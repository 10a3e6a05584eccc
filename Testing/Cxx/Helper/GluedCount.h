// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The topology of tetrahedra that are glued at faces, by other means than those of the code under test.
 */
#ifndef GluedCount_h
#define GluedCount_h

#include "Carver.h"
#include "Mesh.h"

#include <array>

/**
 * Components and tunnels of the tetrahedra that are left, glued at faces only: from classes of corners and
 * edges that are the same by way of faces, and from the components of the surface, counted from scratch.
 */
std::array<int, 2> CountGlued(
  const carving::Tetrahedralization& mesh, const carving::Stream& stream, int step);

#endif
