// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * What nearly touches is made to touch, or to go: points are moved a little.
 */
#ifndef carving_Snap_h
#define carving_Snap_h

#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Progress.h"

#include <string>

/** The widest spacing of a grid, a power of two, to which no point is farther than `tolerance`. */
double GridSpacing(double tolerance);

struct SnappedMesh
{
  carving::ResolvedMesh Mesh;
  int IntersectingPairs = 0; ///< after the first rounding
  /**
   * The farthest that a given point has been moved by, or that a point of `Mesh` is from the triangle of
   * the given mesh that its own is a part of.
   */
  double Distance = 0.0;
};

/**
 * Rounds the points of `given`, which has been cleaned, to a grid and resolves the mesh; points that
 * makes are rounded too, and what crosses by that is resolved, until all points are on the grid and no two
 * triangles meet other than in a shared vertex or edge. Triangles that lose their area are dropped.
 * `PointSources` name the given points, although they have been moved. With more than `maximumPairs`
 * of intersecting triangles nothing is resolved. Returns an empty string or why it came to no end: a
 * grid that is too coarse for a mesh makes ever more crossings.
 */
std::string Snap(const carving::ResolvedMesh& given, double spacing,
  const carving::Progress& progress, double maximumPairs, SnappedMesh& snapped);

#endif
