// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Cuts a level into oriented manifolds (section 3.3 and its reference 27, Gueziec et al., "Cutting and
 * Stitching: Converting Sets of Polygons to Manifold Surfaces").
 */
#ifndef carving_Manifold_h
#define carving_Manifold_h

#include "Core/Stream/Level.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/** The faces of a level in the same order, with vertices of their own where the surface is cut. */
template <int D>
struct ManifoldLevel
{
  std::vector<std::array<int, D>> Faces;
  /** Per vertex: the point of the stream that it is (a copy of); ascending. */
  std::vector<int> Points;
};

/**
 * Cuts along ridges (edges; in the plane, vertices) with more than two faces and at vertices whose
 * faces are not one fan.
 *
 * Where the surface has several sheets at an edge, two faces stay joined if the exterior lies between them:
 * a turn through it, from cell to cell around the edge, leads from one to the other. So what touches along
 * edges stays joined, and the exterior is cut in two there; the surface is closed wherever it bounds a
 * solid. Folds are joined with each other only, two at a ridge that has no other, if they are oriented
 * alike; with both sides of folds on the level, like all other
 * faces.
 *
 * Where what touches is one edge alone, its two copies would have the same vertices. There, faces stay joined
 * if the solid lies between them, and what touches is cut apart; a fold is cut off. As at single vertices,
 * that can only separate pieces or end a tunnel: the surface has no more tunnels than the closed complex.
 * In the plane too, what touches in a vertex is cut apart.
 */
template <int D>
ManifoldLevel<D> CutIntoManifold(const StoredStream<D>& stream, const Level<D>& level);

/** The level as it is: one vertex per point. */
template <int D>
ManifoldLevel<D> KeepUncut(const Level<D>& level);

} // namespace carving

#endif
