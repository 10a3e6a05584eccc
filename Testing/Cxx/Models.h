// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meshes that code makes, for tests. Solids are oriented outward.
 */
#ifndef Models_h
#define Models_h

#include "Mesh.h"

#include <random>

namespace models
{

using carving::TriangleMesh;

TriangleMesh Tetrahedron();
/** Axis-aligned, 12 triangles. */
TriangleMesh Box(const carving::Point& lower, const carving::Point& upper);
/** A unit sphere: an icosahedron, each triangle of which is split in four `subdivisions` times. */
TriangleMesh Sphere(int subdivisions);
/** Around the z axis; n x m quadrilaterals, split in two. */
TriangleMesh Torus(double majorRadius, double minorRadius, int n, int m);
/** An open sheet over the unit square in the xy plane, n x n quadrilaterals, split in two. */
TriangleMesh Sheet(int n);

/** `n` triangles with random corners in a cube: most of them cross others. */
TriangleMesh Soup(int n, std::mt19937_64& random);

TriangleMesh Moved(TriangleMesh mesh, const carving::Point& translation, double scale = 1.0);
/** All triangles with the opposite orientation. */
TriangleMesh Flipped(TriangleMesh mesh);
/** All triangles of both; points are not merged. */
TriangleMesh Joined(const TriangleMesh& a, const TriangleMesh& b);

/** A random mesh and what is known about it. */
struct RandomModel
{
  TriangleMesh Mesh;
  bool Closed = true; ///< every part is a closed solid
};

/**
 * One to four parts, each drawn from all of the above and placed, turned and scaled at random so that
 * some overlap, some solids inside out.
 */
RandomModel MakeRandom(std::mt19937_64& random);

} // namespace models

#endif
