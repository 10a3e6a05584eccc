// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/PlaneProjection.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>

namespace carving::helper
{

PlaneProjection::PlaneProjection(const ResolvedMesh& mesh, int triangle)
  : Mesh(mesh)
{
  const auto& [a, b, c] = mesh.Facets[triangle];
  const Point normal = Cross(mesh.Points[b] - mesh.Points[a], mesh.Points[c] - mesh.Points[a]);
  std::array<int, 3> axes = { 0, 1, 2 };
  std::sort(axes.begin(), axes.end(),
    [&](int i, int k) { return std::abs(normal[i]) > std::abs(normal[k]); });
  // The rounded normal of a sliver may be wrong: its projection along the first axis may have no
  // area.
  for (const int axis : axes)
  {
    this->Axis = axis;
    if (this->OrientationOf(triangle) != CGAL::COLLINEAR)
    {
      break;
    }
  }
  this->Origin = ToExact(mesh.Points[a]);
  const Exact::Vector_3 exact = CGAL::cross_product(
    ToExact(mesh.Points[b]) - this->Origin, ToExact(mesh.Points[c]) - this->Origin);
  this->SlopeU = -exact[this->U()] / exact[this->Axis];
  this->SlopeV = -exact[this->V()] / exact[this->Axis];
  this->SlopeU.exact();
  this->SlopeV.exact();
}

PlaneKernel::Point_2 PlaneProjection::Flat(const ExactPoint& p) const
{
  return { p[this->U()], p[this->V()] };
}

Point PlaneProjection::Lift(const PlaneKernel::Point_2& p) const
{
  const Exact::FT height = this->Origin[this->Axis] +
    this->SlopeU * (p.x() - this->Origin[this->U()]) +
    this->SlopeV * (p.y() - this->Origin[this->V()]);
  Point lifted;
  lifted[this->U()] = CGAL::to_double(p.x().exact());
  lifted[this->V()] = CGAL::to_double(p.y().exact());
  lifted[this->Axis] = CGAL::to_double(height.exact());
  return lifted;
}

CGAL::Orientation PlaneProjection::OrientationOf(int triangle) const
{
  const auto& [a, b, c] = this->Mesh.Facets[triangle];
  const auto flat = [this](int point)
  {
    const Point& p = this->Mesh.Points[point];
    return Inexact::Point_2(p[this->U()], p[this->V()]);
  };
  return CGAL::orientation(flat(a), flat(b), flat(c));
}

} // namespace carving::helper
