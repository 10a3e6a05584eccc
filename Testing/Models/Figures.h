// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Models similar to those in the paper's figures. Every call returns the same mesh. Any two
 * triangles meet only in shared vertices and edges. Solids are closed, manifold and oriented
 * outward.
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
 * Figure 11: a rosette of 25 long, narrow, pointed leaves that do not touch each other. Each leaf
 * is an open sheet. The 800 points and 1,200 triangles are about as many as those of "Yucca leaves"
 * in Table 1.
 */
TriangleMesh YuccaLeaves();

/**
 * Figure 12: a bumpy, flattened ball with tunnels of different widths. One solid of genus
 * SconeGenus.
 */
constexpr int SconeGenus = 12;
TriangleMesh Scone();

/**
 * Figure 13: ten pairs of ribs. Eight pairs connect the spine with the sternum, and two end in
 * between. One solid of genus RibsGenus: sixteen arches connect two columns.
 */
constexpr int RibsGenus = 15;
TriangleMesh Ribs();

/**
 * Figure 14: a tree with at least one leaf. Its parts do not touch each other: each leaf is a bent
 * open sheet of two triangles, and the trunk, every branch and every twig are closed solids of
 * genus 0. By default the tree has about as many points, triangles and tetrahedra as the "Scots
 * Pine" in Table 1.
 */
TriangleMesh Tree(int leaves = 19500);

} // namespace models

#endif
