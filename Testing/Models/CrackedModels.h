// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Solids whose surfaces have cracks: vertices lie on edges of other triangles, but for rounding, or
 * parts do not quite meet.
 */
#ifndef CrackedModels_h
#define CrackedModels_h

#include "Core/Mesh/Mesh.h"

#include <random>

namespace models
{

using carving::TriangleMesh;

/**
 * A rotated torus of triangles that are above a height and others below, where one part has been
 * moved by up to `step` in each direction. At heights other than 0, the border between the parts
 * divides quads of two triangles each.
 */
TriangleMesh TorusInTwoParts(double step, double height, std::mt19937_64& random);

/**
 * A mesh of which random triangles, two in five, are split into four at the midpoints of their
 * edges, as many times as `rounds`. Neighbors stay whole, so that midpoints hang on their edges.
 * Rotated, in single precision.
 */
TriangleMesh WithHangingNodes(TriangleMesh mesh, int rounds, std::mt19937_64& random);

/** Unit cubes, and the surface of their union. */
struct Voxels
{
  TriangleMesh Surface;
  int Count = 0; ///< their volume, too
};

/**
 * Random cells of a grid of n x n x n. Flat parts of the surface consist of large rectangles, so
 * that corners of rectangles lie on sides of others. Rotated, in single precision.
 */
Voxels RandomVoxels(int n, double share, std::mt19937_64& random);

} // namespace models

#endif
