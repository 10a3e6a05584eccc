// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Moves points by a little, so that parts that nearly touch either touch or separate. Not in the
 * paper.
 */
#ifndef carving_Snap_h
#define carving_Snap_h

#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Progress.h"

#include <string>

namespace carving::helper
{

/**
 * The widest grid spacing, a power of two, at which no point is farther than `tolerance` from the
 * grid.
 */
double GridSpacing(double tolerance);

struct SnappedMesh
{
  ResolvedMesh Mesh;
  int IntersectingPairs = 0; ///< after the first rounding
  /**
   * The largest distance by which a given point has moved, or, if larger, the largest distance of a
   * point of `Mesh` from the given triangle that the point's triangle is a part of.
   */
  double Distance = 0.0;
};

/**
 * Rounds the points of `given`, which has been cleaned, to a grid and resolves the mesh, again and
 * again until all points are on the grid and any two triangles meet only in a shared vertex or edge
 * ("iterated snap rounding"). Triangles that lose their area are dropped. `PointSources` refer to
 * the given points, although these have moved. With more than `maximumPairs` of intersecting
 * triangles, nothing is resolved. Returns an empty string, or why snapping did not end: on a grid
 * that is too coarse for the mesh, crossings multiply.
 */
std::string Snap(const ResolvedMesh& given, double spacing, const Progress& progress,
  double maximumPairs, SnappedMesh& snapped);

/**
 * Resolves a mesh whose parts touch but for rounding: takes what is within `tolerance` of each
 * other to touch (ResolveTouching), and rounds new points to a grid. If triangles still cross each
 * other, what is within `tolerance` is taken to touch once more, without rounding. Given points
 * keep their places, unless several become one.
 */
std::string SnapTouching(const ResolvedMesh& given, double tolerance, const Progress& progress,
  double maximumPairs, SnappedMesh& snapped);

/** A way to move points: Snap or SnapTouching. */
using Snapping = decltype(Snap);

} // namespace carving::helper

#endif
