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

struct CrackSplits
{
  int Points = 0;        ///< the number of points added, which follow the others
  bool AreEnough = true; ///< whether no edge passes through a crack any more
};

/**
 * Splits the edges that pass through cracks of M there, in a copy of a mesh. A crack lies between
 * edges of M that each have one triangle, or an odd number, and are at most `width` apart. After
 * that, thin faces may close cracks (SealCracks) that none closed before: an edge from one side of
 * a crack to the other has no thin faces around it. Nor have two edges of M that pass each other
 * where a vertex lies on both, but for rounding: such edges of M are split, too, with their facets.
 * Tetrahedra stay positively oriented; edges for which rounding prevents that stay whole. Each
 * round makes new edges, some of which pass through other cracks. Where TetGen has added points on
 * the sides of cracks, further rounds make ever more of them. Without edges to split, there is no
 * copy.
 */
CrackSplits SplitEdgesThroughCracks(
  const Tetrahedralization& mesh, double width, Tetrahedralization& split);

/** Whether M has cracks that edges pass through, however many are split. */
bool HasCracksThatStayOpen(const Tetrahedralization& mesh);

} // namespace carving::helper

#endif
