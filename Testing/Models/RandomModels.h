// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Random meshes, for tests of what holds for any mesh.
 */
#ifndef RandomModels_h
#define RandomModels_h

#include "Core/Mesh/Mesh.h"

#include <random>

namespace models
{

using carving::TriangleMesh;

/** `n` triangles with random corners in a cube: most of them cross others. */
TriangleMesh Soup(int n, std::mt19937_64& random);

/**
 * `n` right triangles on planes of a grid, so small that many are coplanar and overlap, touch or coincide,
 * in either orientation.
 */
TriangleMesh GridSoup(int n, std::mt19937_64& random);

/** `n` boxes on a small grid: glued in sides, edges and corners, overlapped, nested, some inside out. */
TriangleMesh BoxSoup(int n, std::mt19937_64& random);

/** `n` boxes, balls and rings, all aligned and on places of a grid, so that many sides coincide and overlap. */
TriangleMesh Assembly(int n, std::mt19937_64& random);

/** A mesh twice, the second time with every coordinate off by up to `noise`. */
TriangleMesh Doubled(const TriangleMesh& mesh, double noise, std::mt19937_64& random);

/** A random mesh and what is known about it. */
struct RandomModel
{
  TriangleMesh Mesh;
  bool Closed = true; ///< every part is a closed solid
};

/**
 * One to four parts, each drawn from all shapes and placed, turned and scaled at random so that
 * some overlap, some solids inside out.
 */
RandomModel MakeRandom(std::mt19937_64& random);

} // namespace models

#endif
