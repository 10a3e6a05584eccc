// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Makes unions of faces of the triangles of M, by vertices on them. Not in the paper.
 */
#ifndef carving_Cut_h
#define carving_Cut_h

#include "Helper/Enclosing/PiercedMesh.h"

#include <functional>

namespace carving::helper
{

struct CutLimits
{
  std::size_t Effort; ///< changes of the mesh that are tried
  std::size_t Points; ///< that are added
};

/**
 * Makes a union of faces of each part of M that is no face, the largest first: vertices are put
 * where edges of the part pierce faces and edges of tetrahedra pierce the part. Where parts cross
 * each other, they share vertices afterwards. Those parts that resist still pierce tetrahedra, or
 * lie on faces that extend beyond them. What is within `tolerance`, a length, of a part counts as
 * being on it.
 */
void Cut(PiercedMesh& mesh, double tolerance, const CutLimits& limits,
  const std::function<bool(double)>& progress);

} // namespace carving::helper

#endif
