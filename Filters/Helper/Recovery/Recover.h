// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Recovers the triangles of M that a Delaunay tetrahedralization lacks. Not in the paper.
 */
#ifndef carving_Recover_h
#define carving_Recover_h

#include "Helper/Enclosing/PiercedMesh.h"

#include <functional>

namespace carving::helper
{

struct RecoveryLimits
{
  std::ptrdiff_t Steps;      ///< comparisons of a triangle or a point with a tetrahedron
  bool MayAddPoints;         ///< off M
  double MissingShare = 1.0; ///< nothing is recovered if more of the parts are no faces
};

/**
 * Makes faces of the parts of M, one after the other: the tetrahedra that a part meets are removed,
 * and the cavity is filled again around the part. The mesh is valid at any time, and a part that is
 * a face stays one. Returns the number of parts that are not faces.
 */
std::size_t Recover(
  PiercedMesh& mesh, const RecoveryLimits& limits, const std::function<bool(double)>& progress);

} // namespace carving::helper

#endif
