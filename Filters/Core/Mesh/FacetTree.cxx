// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/FacetTree.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>

namespace carving
{
namespace
{

double SquaredDistanceToSegment(const Point& a, const Point& b, const Point& p)
{
  const Point along = b - a, toPoint = p - a;
  const double t = std::clamp(Dot(toPoint, along) / Dot(along, along), 0.0, 1.0);
  const Point offset = toPoint - t * along;
  return Dot(offset, offset);
}

} // namespace

template <int D>
double Diagonal(const ResolvedInput<D>& mesh)
{
  Box box;
  for (const auto& facet : mesh.Facets)
  {
    for (const int corner : facet)
    {
      box.Add(mesh.Points[corner]);
    }
  }
  return box.IsEmpty() ? 0.0 : Length(box.Upper - box.Lower);
}

double DistanceTo(const FacetCorners<2>& edge, const Point& p)
{
  return std::sqrt(SquaredDistanceToSegment(edge[0], edge[1], p));
}

double DistanceTo(const FacetCorners<3>& triangle, const Point& p)
{
  const Point normal = Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  double squared = Box::Infinity;
  for (int i = 0; i < 3; ++i)
  {
    // Of a point beyond some sides, the closest point of the triangle is on one of these.
    const Point &a = triangle[i], &b = triangle[(i + 1) % 3];
    if (!(Dot(Cross(b - a, p - a), normal) >= 0.0))
    {
      squared = std::min(squared, SquaredDistanceToSegment(a, b, p));
    }
  }
  return squared < Box::Infinity ? std::sqrt(squared)
                                 : std::abs(Dot(normal, p - triangle[0])) / Length(normal);
}

template <int D>
FacetTree<D>::FacetTree(const ResolvedInput<D>& mesh)
  : BoxTree<FacetItems<D>>(FacetItems<D>(mesh))
{
}

template <int D>
typename FacetTree<D>::Closest FacetTree<D>::Find(const Point& p, double enough, int nearby) const
{
  Closest closest = { Box::Infinity, -1 };
  const auto consider = [&](int facet)
  {
    const double distance = DistanceTo(this->GetItems().CornersOf(facet), p);
    if (distance < closest.Distance)
    {
      closest = { distance, facet };
    }
    return closest.Distance <= enough ? 0.0 : closest.Distance * closest.Distance;
  };
  this->ForEachNear(p, nearby >= 0 ? consider(nearby) : Box::Infinity, consider);
  return closest;
}

template double Diagonal<2>(const ResolvedInput<2>&);
template double Diagonal<3>(const ResolvedInput<3>&);
template class FacetTree<2>;
template class FacetTree<3>;

} // namespace carving
