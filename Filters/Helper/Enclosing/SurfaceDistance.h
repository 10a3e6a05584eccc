// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The distance of triangles from M.
 *
 * The tree is CGAL's and not the core's FacetTree, which always finds the closest facet: most
 * questions here are whether any triangle of M is within a distance, and end at the first triangle
 * found.
 */
#ifndef carving_SurfaceDistance_h
#define carving_SurfaceDistance_h

#include "Core/Mesh/Mesh.h"

#include <memory>

namespace carving::helper
{

/** Not for use by several threads: answers start from the triangle of M that the last one found. */
class SurfaceDistance
{
public:
  /** The surface must have a facet. It is copied. */
  explicit SurfaceDistance(const ResolvedMesh& surface);
  ~SurfaceDistance();

  using Corners = std::array<Point, 3>;

  /**
   * Whether every point of a triangle is within `distance` of M, where the distance is exact to 5
   * %.
   */
  bool IsWithin(const Corners& triangle, double distance) const;

  /**
   * The distance from M of the farthest point of a triangle, to within 5 %, but no less than
   * `atLeast`.
   */
  double Farthest(const Corners& triangle, double atLeast) const;

private:
  struct Tree;
  std::unique_ptr<Tree> Locator;
};

} // namespace carving::helper

#endif
