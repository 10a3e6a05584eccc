// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The distance of triangles from M.
 *
 * Most questions are whether any triangle of M is within a distance. A search ends at the first one
 * found, and the next search begins with it. The core's FaceDistance, which looks for the closest
 * triangle, takes up to a tenth longer.
 */
#ifndef carving_SurfaceDistance_h
#define carving_SurfaceDistance_h

#include "Core/Mesh/FacetTree.h"

#include <memory>

namespace carving::helper
{

/**
 * Each thread needs a copy: an answer starts from the triangle of M that the last one found. Copies
 * share the tree.
 */
class SurfaceDistance
{
public:
  /** The surface must have a facet, and outlive this object and its copies. */
  explicit SurfaceDistance(const ResolvedMesh& surface);

  using Corners = std::array<Point, 3>;

  /**
   * Whether every point of a triangle is within `distance` of M, where the distance is exact to 5
   * % or to the resolution. The answer does not depend on earlier ones.
   */
  bool IsWithin(const Corners& triangle, double distance);

  /** The length below which rounding errors decide. */
  double GetResolution() const
  {
    return this->Resolution;
  }

  /** The distance of a point from M. */
  double Distance(const Point& point);

  /**
   * The distance from M of the farthest point of a triangle, to within 5 % or the resolution, but
   * no less than `atLeast`.
   */
  double Farthest(const Corners& triangle, double atLeast);

private:
  double ToTriangle(int triangle, const Point& point) const;
  bool HasWithin(const Point& point, double distance);

  enum class Nearness
  {
    CentroidIsFar,  ///< farther than asked for
    CentroidIsNear, ///< and other points may be far
    AllIsNear,      ///< every point is within the distance, but for the accuracy
  };
  Nearness FindNearness(const Corners& triangle, double distance);
  bool LastHasWithin(const Corners& triangle, double distance) const;

  std::shared_ptr<const FacetTree<3>> Surface;
  double Resolution;
  int Last = 0; ///< the triangle found last; often close to the next point, too
};

} // namespace carving::helper

#endif
