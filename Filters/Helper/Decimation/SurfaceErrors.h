// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * What a new position of a vertex costs.
 */
#ifndef carving_SurfaceErrors_h
#define carving_SurfaceErrors_h

#include "Core/Mesh/FaceDistance.h"
#include "Helper/Decimation/Placement.h"

#include <vector>

namespace carving::helper
{

/** The errors of a surface whose edges collapse, measured from the surface as given. */
class SurfaceErrors
{
public:
  /** `fromStart` measures distances from the surface as given. Both must outlive this object. */
  SurfaceErrors(const SurfaceMesh& surface, const FaceDistance<3>& fromStart);

  /** The quadric error of positions that an edge may collapse into, about its midpoint. */
  LocalError OfEdge(HalfEdge edge) const;

  /** The quadric error of positions that a vertex may move to, about its position. */
  LocalError OfVertex(Vertex vertex) const;

  /**
   * The cost of w in the middle of a star: the quadric error, or the squared largest distance from
   * the surface as given if that weighs more.
   *
   * Quadrics know planes only: where parts of the surface end, or a gap is bridged, a vertex on all
   * planes can be far away. The distance weighs the same for small faces as for large ones, since a
   * small face far away makes the whole level as bad. The distance from M would not do: where the
   * given surface is far from M itself, collapses that change little would cost most.
   */
  double CostOf(const Star& star, const LocalError& error, const Point& w) const;

  /**
   * The largest distance of faces around w from the surface as given, but no less than `atLeast`:
   * that of w and of the faces' centroids.
   */
  double FindFarthest(const Star& star, const Point& w, double atLeast) const;

  /** Lets a vertex stand for the faces of a removed one, too. */
  void Merge(Vertex remaining, Vertex removed)
  {
    this->Quadrics[remaining].Add(this->Quadrics[removed]);
  }

private:
  void AddPlanes();

  const SurfaceMesh& Surface;
  const FaceDistance<3>& FromStart;
  Point Origin;                  ///< of the quadrics
  double Area = 0.0;             ///< of the surface as given
  std::vector<Quadric> Quadrics; ///< per vertex: the planes of the faces that it stands for
};

} // namespace carving::helper

#endif
