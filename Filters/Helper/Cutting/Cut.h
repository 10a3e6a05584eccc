// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Makes unions of faces of the triangles of M, by vertices on them. Not in the paper.
 */
#ifndef carving_Cut_h
#define carving_Cut_h

#include "Helper/Enclosing/PiercedMesh.h"

#include <functional>
#include <vector>

namespace carving::helper
{

/**
 * A tolerance for Cut, of the mesh's diagonal: some thousand times the rounding of a coordinate.
 */
constexpr double CutTolerance = 1e-12;

struct CutLimits
{
  std::size_t Effort; ///< changes of the mesh that are tried
  std::size_t Points; ///< that are added
  /** Of M's area: once 700,000 changes have been tried, every 100,000 have to meet as much. */
  double LeastYield = 0.0;
};

/**
 * Makes a union of faces of each part of M that is no face: vertices are put where edges of the
 * part pierce faces and edges of tetrahedra pierce the part. Parts that have much area for the
 * tetrahedra that they meet come first, since the limits may not let all parts have their turn.
 * Where parts cross each other, they share vertices afterwards. Those parts that resist still
 * pierce tetrahedra, or lie on faces that extend beyond them. What is within `tolerance`, a length,
 * of a part counts as being on it. The result does not depend on `threads`.
 *
 * Needles among the parts that would be divided are returned, not given back to the mesh: parts
 * whose pieces would together be more than twenty times as long as themselves, since each piece
 * would meet as many tetrahedra. The mesh has only the gaps between the needle's edges and the
 * vertices along them, which are off the edges by a rounding: a closed part of M would have cracks
 * otherwise. The caller gives needles back, after vertices have been detached if they will be: a
 * needle in the mesh keeps the vertices around it from being detached.
 */
[[nodiscard]] std::vector<Subdivision::Part> Cut(PiercedMesh& mesh, double tolerance,
  const CutLimits& limits, int threads, const std::function<bool(double)>& progress);

} // namespace carving::helper

#endif
