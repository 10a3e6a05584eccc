// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Judges surfaces with exact arithmetic, by other means than those of the code under test.
 */
#ifndef Checks_h
#define Checks_h

#include "Core/Mesh/Mesh.h"

#include <vector>

namespace checks
{

/** Pairs of triangles whose intersection is more than the corners that they share. Exact. */
int CountCrossings(
  const std::vector<carving::Point>& points, const std::vector<carving::Triangle>& triangles);

/** Whether every edge is passed as often in one direction as in the other. */
bool IsClosed(const std::vector<carving::Triangle>& triangles);

/** Six times the volume that a closed surface bounds. Exact, but for a last rounding. */
double SixVolume(
  const std::vector<carving::Point>& points, const std::vector<carving::Triangle>& triangles);

/** The triangles that a ray from a point passes. Exact; the ray is in line with nothing. */
struct Passages
{
  int Sum = 0;   ///< those that it passes to their front, less those that it passes to their back
  int Count = 0; ///< all of them
};
Passages CountPassages(const std::vector<carving::Point>& points,
  const std::vector<carving::Triangle>& triangles, const carving::Point& point);

/** Whether a closed surface has a point on or inside it. Exact. */
bool Encloses(const std::vector<carving::Point>& points,
  const std::vector<carving::Triangle>& triangles, const carving::Point& point);

/** The vertices of the convex hull, sorted, and six times its volume. */
struct Hull
{
  std::vector<carving::Point> Vertices;
  double SixVolume;
};
Hull ConvexHull(const std::vector<carving::Point>& points);

/** Whether the line through a point in a direction meets any triangle. Exact. */
bool LineHits(const std::vector<carving::Point>& points,
  const std::vector<carving::Triangle>& triangles, const carving::Point& point,
  const carving::Point& direction);

/** The distance of a point from the triangle nearest to it. */
double DistanceTo(const std::vector<carving::Point>& points,
  const std::vector<carving::Triangle>& triangles, const carving::Point& point);

} // namespace checks

#endif
