// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks of surfaces in exact arithmetic, independent of the code under test.
 */
#ifndef Checks_h
#define Checks_h

#include "Core/Mesh/Mesh.h"

#include <array>
#include <vector>

namespace checks
{

/** Pairs of triangles whose intersection is more than the corners that they share. Exact. */
int CountCrossings(
  const std::vector<carving::Point>& points, const std::vector<carving::Triangle>& triangles);

/** The triangles with equal points as one: where a surface has been cut, it may touch itself. */
std::vector<carving::Triangle> WithPointsMerged(
  const std::vector<carving::Point>& points, std::vector<carving::Triangle> triangles);

/** Whether every edge is used equally often in both directions. */
bool IsClosed(const std::vector<carving::Triangle>& triangles);

/** For each facet of M, the number of faces of cells that lie on it. */
template <int D>
std::vector<int> CountFaces(const carving::Decomposition<D>& mesh)
{
  std::vector<int> counts(mesh.Surface.Facets.size(), 0);
  for (const int facet : mesh.Constraints.OfFaces)
  {
    ++counts[facet];
  }
  return counts;
}

/** Six times the volume of all tetrahedra; NaN if any is not positively oriented. */
double SixVolume(const carving::Tetrahedralization& mesh);

/** Six times the volume inside a closed surface. Exact, except for a final rounding. */
double SixVolume(
  const std::vector<carving::Point>& points, const std::vector<carving::Triangle>& triangles);

/** The triangles that a ray from a point crosses. Exact; the ray's direction is generic. */
struct Passages
{
  int Sum = 0;   ///< crossings from back to front, minus crossings from front to back
  int Count = 0; ///< all crossings
};
Passages CountPassages(const std::vector<carving::Point>& points,
  const std::vector<carving::Triangle>& triangles, const carving::Point& point);

/** Whether a point is on or inside a closed surface. Exact. */
bool Encloses(const std::vector<carving::Point>& points,
  const std::vector<carving::Triangle>& triangles, const carving::Point& point);

/** The vertices of the convex hull, sorted, and six times its volume. */
struct Hull
{
  std::vector<carving::Point> Vertices;
  double SixVolume;
};
Hull ConvexHull(const std::vector<carving::Point>& points);

/** Whether the line through a point along a direction meets any triangle. Exact. */
bool LineHits(const std::vector<carving::Point>& points,
  const std::vector<carving::Triangle>& triangles, const carving::Point& point,
  const carving::Point& direction);

/** The distance of a point from the closest triangle. */
double DistanceTo(const std::vector<carving::Point>& points,
  const std::vector<carving::Triangle>& triangles, const carving::Point& point);

/** The largest distance from a mesh of the points of a grid, 40 to a side, on a triangle. */
double FarthestOfGrid(const std::vector<carving::Point>& points,
  const std::vector<carving::Triangle>& triangles, const std::array<carving::Point, 3>& t);

} // namespace checks

#endif
