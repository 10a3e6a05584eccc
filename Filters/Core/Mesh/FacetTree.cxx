// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/FacetTree.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>

namespace carving
{
namespace
{

double DistanceToSegment(const Point& a, const Point& b, const Point& p)
{
  const Point along = b - a, toPoint = p - a;
  const double t = std::clamp(Dot(toPoint, along) / Dot(along, along), 0.0, 1.0);
  return Length(toPoint - t * along);
}

} // namespace

double DistanceTo(const FacetCorners<2>& edge, const Point& p)
{
  return DistanceToSegment(edge[0], edge[1], p);
}

double DistanceTo(const FacetCorners<3>& triangle, const Point& p)
{
  const auto& [a, b, c] = triangle;
  const Point normal = Cross(b - a, c - a);
  const bool above = Dot(Cross(b - a, p - a), normal) >= 0.0 &&
    Dot(Cross(c - b, p - b), normal) >= 0.0 && Dot(Cross(a - c, p - c), normal) >= 0.0;
  return above ? std::abs(Dot(normal, p - a)) / Length(normal)
               : std::min({ DistanceToSegment(a, b, p), DistanceToSegment(b, c, p),
                   DistanceToSegment(c, a, p) });
}

template <int D>
FacetTree<D>::FacetTree(const ResolvedInput<D>& mesh)
  : BoxTree<FacetItems<D>>(FacetItems<D>(mesh))
{
}

template <int D>
typename FacetTree<D>::Closest FacetTree<D>::Find(const Point& p) const
{
  Closest closest = { {}, Box::Infinity, -1 };
  this->ForEachNear(p, Box::Infinity,
    [&](int facet)
    {
      const FacetCorners<D> corners = this->GetItems().CornersOf(facet);
      const double distance = DistanceTo(corners, p);
      if (distance < closest.Distance)
      {
        closest = { corners, distance, facet };
      }
      return closest.Distance * closest.Distance;
    });
  return closest;
}

template class FacetTree<2>;
template class FacetTree<3>;

} // namespace carving
