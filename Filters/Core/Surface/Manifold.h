// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Cutting of a level into oriented manifolds (section 3.3 and its reference 27, Gueziec et al.,
 * "Cutting and Stitching: Converting Sets of Polygons to Manifold Surfaces").
 */
#ifndef carving_Manifold_h
#define carving_Manifold_h

#include "Core/Stream/Level.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/**
 * The faces of a level in the same order. Where the surface is cut, they have different vertices.
 */
template <int D>
struct ManifoldLevel
{
  std::vector<std::array<int, D>> Faces;
  /** Per vertex: the point of the stream that it is a copy of; ascending. */
  std::vector<int> Points;
};

/**
 * Cuts along ridges (edges; in the plane, vertices) with more than two faces, and at vertices whose
 * faces do not form one fan.
 *
 * At an edge of more than two faces, two faces stay joined if the exterior lies between them, that
 * is, if a rotation through exterior cells around the edge leads from one to the other. Parts that
 * touch along edges thus stay joined, the exterior is cut in two there, and the surface is closed
 * wherever it bounds a solid. Folds that show one side are joined to each other only: two at a
 * ridge without other folds, if their orientations agree. Folds that show both sides are treated
 * like all other faces.
 *
 * Where parts touch in a single edge, this would leave two copies of the edge with the same
 * vertices. Faces there stay joined if the solid lies between them, so that the parts are cut
 * apart, and a fold is cut off. Such a cut, like one at a single vertex, can only separate pieces
 * or end a tunnel: the surface has no more tunnels than the closed complex. In the plane, parts
 * that touch in a vertex are cut apart, too.
 */
template <int D>
ManifoldLevel<D> CutIntoManifold(const StoredStream<D>& stream, const Level<D>& level);

/** The level without cuts: one vertex per point. */
template <int D>
ManifoldLevel<D> KeepUncut(const Level<D>& level);

} // namespace carving

#endif
