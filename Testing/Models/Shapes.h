// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Simple meshes. Solids are oriented outward.
 */
#ifndef Shapes_h
#define Shapes_h

#include "Core/Mesh/Mesh.h"

namespace models
{

using carving::TriangleMesh;

TriangleMesh Tetrahedron();
/** Axis-aligned, 12 triangles. */
TriangleMesh Box(const carving::Point& lower, const carving::Point& upper);
/** A unit sphere: an icosahedron whose triangles are split into four, `subdivisions` times. */
TriangleMesh Sphere(int subdivisions);
/** A prism of radius 1 along the z axis. */
TriangleMesh Prism(int sides, double from, double to);
/** Three spheres, one in the other, much closer to each other than their points. */
TriangleMesh CloseSpheres();
/** A torus around the z axis: n x m quadrilaterals, split in two. */
TriangleMesh Torus(double majorRadius, double minorRadius, int n, int m);
/** Two tori of 96 quadrilaterals each that cross each other. */
TriangleMesh CrossingTori();
/**
 * A torus with irregular bumps, of about so many points, but at least 300: a mesh of any size for
 * measurements.
 */
TriangleMesh BumpyTorus(int points);
/** An open sheet over the unit square in the xy plane, n x n quadrilaterals, split in two. */
TriangleMesh Sheet(int n);
/**
 * The surface of the box from 0 to `size`. Side i is a grid of n[i] by n[i] squares with points of
 * its own, so that vertices of fine sides lie on edges of coarse ones.
 */
TriangleMesh PatchedBox(const carving::Point& size, const std::array<int, 6>& n);
/** n upright triangles along x, each of which crosses each of n others along y: n x n pairs. */
TriangleMesh Lattice(int n);

TriangleMesh Moved(TriangleMesh mesh, const carving::Point& translation, double scale = 1.0);
/** The mesh with each point moved along x by twice its z. */
TriangleMesh Sheared(TriangleMesh mesh);
/** The mesh with coordinates rounded to single precision. */
TriangleMesh InSinglePrecision(TriangleMesh mesh);
/** The mesh with the opposite orientation. */
TriangleMesh Flipped(TriangleMesh mesh);
/** The triangles of both meshes; points are not merged. */
TriangleMesh Joined(const TriangleMesh& a, const TriangleMesh& b);

} // namespace models

#endif
