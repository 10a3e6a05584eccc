// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_PlaneProjection_h
#define carving_PlaneProjection_h

#include "Helper/Base/PlaneTriangulation.h"
#include "Helper/Resolve/CutPoints.h"

namespace carving::helper
{

/** The projection of a triangle's plane along the coordinate axis that is closest to its normal. */
class PlaneProjection
{
public:
  /** The mesh must outlive the projection. */
  PlaneProjection(const ResolvedMesh& mesh, int triangle);

  PlaneKernel::Point_2 Flat(const ExactPoint& p) const;

  /**
   * The rounded point of the plane whose projection is `p`. Equal points give equal results,
   * however they were constructed.
   */
  Point Lift(const PlaneKernel::Point_2& p) const;

  /** The orientation of the projection of a triangle in the plane. */
  CGAL::Orientation OrientationOf(int triangle) const;

private:
  int U() const
  {
    return (this->Axis + 1) % 3;
  }
  int V() const
  {
    return (this->Axis + 2) % 3;
  }

  const ResolvedMesh& Mesh;
  int Axis;
  Exact::Point_3 Origin;
  Exact::FT SlopeU, SlopeV; ///< of the plane along U and V
};

} // namespace carving::helper

#endif
