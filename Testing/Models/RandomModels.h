// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Random meshes, for tests of properties of all meshes.
 */
#ifndef RandomModels_h
#define RandomModels_h

#include "Core/Mesh/Mesh.h"

#include <random>

namespace models
{

using carving::TriangleMesh;

/**
 * The number of random cases: a slice by default, more through a variable of the environment. Under
 * a sanitizer, where tests take ten times as long, the slice is a quarter.
 */
int NumberOfCases(const char* variable, int slice);

/** `n` triangles with random corners in a cube; most of them cross others. */
TriangleMesh Soup(int n, std::mt19937_64& random);

/**
 * `n` right triangles, in either orientation, in the planes of a grid so small that many are
 * coplanar and overlap, touch or coincide.
 */
TriangleMesh GridSoup(int n, std::mt19937_64& random);

/**
 * `n` boxes on a small grid: glued at sides, edges and corners, overlapping, nested, some inverted.
 */
TriangleMesh BoxSoup(int n, std::mt19937_64& random);

/**
 * `n` boxes, balls and rings, aligned and placed on a grid, so that many sides coincide and
 * overlap.
 */
TriangleMesh Assembly(int n, std::mt19937_64& random);

/**
 * `n` flat discs of 5 to 20 corners without thickness, in the planes of a small grid, so that some
 * cross or overlap.
 */
TriangleMesh Discs(int n, std::mt19937_64& random);

/** A mesh, rotated at random about the origin. */
TriangleMesh Rotated(TriangleMesh mesh, std::mt19937_64& random);

/** A mesh and a copy of it whose coordinates differ by up to `noise`. */
TriangleMesh Doubled(const TriangleMesh& mesh, double noise, std::mt19937_64& random);

/** Two surfaces so close that rounding crossings to doubles creates others, again and again. */
TriangleMesh NearlyEqualSpheres();

/** A random mesh and its known properties. */
struct RandomModel
{
  TriangleMesh Mesh;
  bool Closed = true; ///< every part is a closed solid
};

/**
 * One to four random shapes, placed, rotated and scaled at random, so that some overlap; some
 * solids are inverted.
 */
RandomModel MakeRandom(std::mt19937_64& random);

} // namespace models

#endif
