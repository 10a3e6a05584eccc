// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Splits triangles along each other where parts touch but for rounding, as CAD programs imprint
 * parts on each other. Not in the paper.
 */
#ifndef carving_Imprint_h
#define carving_Imprint_h

#include "Core/Mesh/Mesh.h"

#include <utility>
#include <vector>

namespace carving::helper
{

/**
 * Takes points that are within `tolerance` of each other as one. Drops triangles without area. Adds
 * the largest distance by which a point that has a source moves to `distance`.
 */
ResolvedMesh Weld(ResolvedMesh mesh, double tolerance, double& distance);

/**
 * Splits edges at the points that are within `tolerance` of them and where other edges pass them
 * within the tolerance, and triangles along the points and edges that lie on them within twice the
 * tolerance and along the segments in which `pairs` of them cross. Triangles that lie on each other
 * are split into the same pieces, which become one. New points are rounded, others keep their
 * places. `mesh` has been welded. Takes O((n + k) log n) time for n triangles with k incidences.
 */
ResolvedMesh Imprint(
  ResolvedMesh mesh, const std::vector<std::pair<int, int>>& pairs, double tolerance);

} // namespace carving::helper

#endif
