// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Models like those in the figures of "Carving for topology simplification of polygonal meshes". Every
 * call makes the same mesh. No two triangles meet other than in shared vertices and edges. Solids are
 * closed, manifold and oriented outward.
 */
#ifndef Figures_h
#define Figures_h

#include "Core/Mesh/Mesh.h"

namespace models
{

using carving::TriangleMesh;

/** Figure 4: two unit spheres of 642 points each. Two solids of genus 0. */
TriangleMesh TwoSpheres();

/** Figure 10: spheres of 642 points each at the corners of a unit cube. Eight solids of genus 0. */
TriangleMesh EightSpheres();

/**
 * Figure 11: a rosette of 25 long, narrow, pointed leaves that do not touch each other. Open sheets, one
 * component per leaf: 800 points and 1,200 triangles, about as many as Table 1's "Yucca leaves".
 */
TriangleMesh YuccaLeaves();

/** Figure 12: a bumpy flattened ball with tunnels of different widths. One solid of this genus. */
constexpr int SconeGenus = 12;
TriangleMesh Scone();

/**
 * Figure 13: ribs in ten pairs. Eight go all the way around from the spine to the sternum, and the
 * other two end in between. One solid of this genus: sixteen arches join two columns.
 */
constexpr int RibsGenus = 15;
TriangleMesh Ribs();

/**
 * Figure 14: a tree with that many leaves, at least one. Nothing touches anything else: each leaf is an
 * open sheet of two triangles with a kink, and the trunk, every branch and every twig are closed solids
 * of genus 0. By default it has about as many points, triangles and tetrahedra as Table 1's "Scots Pine".
 */
TriangleMesh Tree(int leaves = 19500);

} // namespace models

#endif
