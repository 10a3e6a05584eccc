// SPDX-License-Identifier: BSD-3-Clause
#ifndef Blocks_h
#define Blocks_h

#include "Core/Mesh/Mesh.h"

namespace models
{

/**
 * 26 walls on a floor plan of five by five rooms: closed boxes without crossings, some of which
 * touch in parts of their sides. Each side is a grid of points, with cells of a size that differs
 * between walls. `density` is the number of cells along the finest wall. The walls are turned, so
 * that points of a plane are off it by a rounding.
 */
carving::TriangleMesh Blocks(int density);

} // namespace models

#endif
