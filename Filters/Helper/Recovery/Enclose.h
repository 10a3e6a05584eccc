// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The strategy that always succeeds: a Delaunay tetrahedralization in which every tetrahedron that
 * M pierces is kept, that is, never carved. Not in the paper.
 */
#ifndef carving_Enclose_h
#define carving_Enclose_h

#include "Core/Mesh/Mesh.h"
#include "Helper/Enclosing/KeptDistances.h"

#include <functional>
#include <vector>

namespace carving::helper
{

/** Shares of the diagonal of M's bounding box. */
struct EnclosingTolerances
{
  double Distance;       ///< from M that kept tetrahedra may reach; 0: no points are added on M
  double Flatness = 0.0; ///< of the parts that get other triangles (FlatParts.h); 0: none does
};

/** How far an enclosure is from M. */
struct Enclosure
{
  KeptDistances Distances;
  double MetShare;     ///< the share of M's area that is faces
  int ResolvedPairs;   ///< the pairs of triangles that crossed before the input was resolved, or 0
  double FlatDistance; ///< at most so far are the new triangles of flat parts from M
};

/**
 * Tetrahedralizes the points of `input`, which has been cleaned and may cross itself, and the
 * `further` points of C0; not all points may lie in one plane. Triangles of M are recovered as
 * faces where they do not cross each other. Points are added until no kept tetrahedron reaches
 * farther from M than the tolerance, or until there are too many points.
 *
 * The result does not depend on `threads`. In it, `Kept` marks the kept tetrahedra, `Surface` has
 * the faces that overlap a triangle of M in an area, as parts of M, `Unresolved` is the input, with
 * other triangles in some flat parts, or, if more of that is met, the resolved input, and
 * `MetShares` is there.
 */
Enclosure Enclose(const ResolvedMesh& input, const std::vector<Point>& further,
  const EnclosingTolerances& tolerances, int threads, const std::function<bool(double)>& progress,
  Tetrahedralization& result);

} // namespace carving::helper

#endif
