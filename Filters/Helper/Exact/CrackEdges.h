// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Edges of tetrahedra that pass through cracks. Not in the paper.
 */
#ifndef carving_CrackEdges_h
#define carving_CrackEdges_h

#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/**
 * Splits the edges that pass through cracks of M there, in a copy of a mesh. A crack lies between
 * edges of M that each have one triangle, or an odd number, and are at most `width` apart. After
 * that, thin faces may close cracks (SealCracks) that none closed before: an edge from one side of
 * a crack to the other has no thin faces around it. Nor have two edges of M that pass each other
 * where a vertex lies on both, but for rounding: such edges of M are split, too, with their facets.
 * Tetrahedra stay positively oriented; edges for which rounding prevents that stay whole. Returns
 * the number of points added, which follow the others. Without such edges, there is no copy.
 */
int SplitEdgesThroughCracks(
  const Tetrahedralization& mesh, double width, Tetrahedralization& split);

} // namespace carving::helper

#endif
