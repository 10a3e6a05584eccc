// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/FacetTree.h"

#include "Core/Mesh/MedianSplit.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace carving
{
namespace
{

constexpr int LeafSize = 4;

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
  : Mesh(mesh)
  , Facets(mesh.Facets.size())
{
  std::iota(this->Facets.begin(), this->Facets.end(), 0);
  std::vector<Point> centers;
  centers.reserve(mesh.Facets.size());
  for (const auto& facet : mesh.Facets)
  {
    Point lower, upper;
    const FacetCorners<D> corners = CornersOf<D>(mesh.Points, facet);
    GetBounds({ corners.begin(), corners.end() }, lower, upper);
    centers.push_back(lower + upper);
  }
  this->Build(centers, 0, static_cast<int>(this->Facets.size()));
}

template <int D>
void FacetTree<D>::Build(const std::vector<Point>& centers, int first, int last)
{
  const std::size_t index = this->Nodes.size();
  Node node = { this->Mesh.Points[this->Mesh.Facets[this->Facets[first]][0]], {}, first, last, 0 };
  node.Upper = node.Lower;
  for (int i = first; i < last; ++i)
  {
    for (const int corner : this->Mesh.Facets[this->Facets[i]])
    {
      const Point& p = this->Mesh.Points[corner];
      for (int k = 0; k < 3; ++k)
      {
        node.Lower[k] = std::min(node.Lower[k], p[k]);
        node.Upper[k] = std::max(node.Upper[k], p[k]);
      }
    }
  }
  this->Nodes.push_back(node);
  if (last - first <= LeafSize)
  {
    return;
  }
  const auto begin = this->Facets.begin();
  const int middle = static_cast<int>(
    SplitAtMedian(
      begin + first, begin + last, node.Upper - node.Lower,
      [&](int facet) -> const Point& { return centers[facet]; }, [](int facet) { return facet; }) -
    begin);
  this->Build(centers, first, middle);
  this->Nodes[index].Second = static_cast<int>(this->Nodes.size());
  this->Build(centers, middle, last);
}

template <int D>
double FacetTree<D>::SquaredDistance(const Node& node, const Point& p)
{
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double outside = std::max({ 0.0, node.Lower[k] - p[k], p[k] - node.Upper[k] });
    sum += outside * outside;
  }
  return sum;
}

template <int D>
typename FacetTree<D>::Closest FacetTree<D>::Find(const Point& p) const
{
  Closest closest = { {}, std::numeric_limits<double>::infinity() };
  double squared = closest.Distance;
  std::array<std::pair<double, int>, 64> open; // 2^31 facets have at most 31 levels
  int count = 0;
  open[count++] = { 0.0, 0 };
  while (count > 0)
  {
    const auto [bound, index] = open[--count];
    if (bound >= squared)
    {
      continue;
    }
    const Node& node = this->Nodes[index];
    if (node.Second > 0)
    {
      std::pair<double, int> near = { SquaredDistance(this->Nodes[index + 1], p), index + 1 };
      std::pair<double, int> far = { SquaredDistance(this->Nodes[node.Second], p), node.Second };
      if (far < near)
      {
        std::swap(near, far);
      }
      open[count++] = far;
      open[count++] = near; // first
      continue;
    }
    for (int i = node.First; i < node.Last; ++i)
    {
      const auto corners = CornersOf<D>(this->Mesh.Points, this->Mesh.Facets[this->Facets[i]]);
      const double distance = DistanceTo(corners, p);
      if (distance < closest.Distance)
      {
        closest = { corners, distance };
        squared = distance * distance;
      }
    }
  }
  return closest;
}

template class FacetTree<2>;
template class FacetTree<3>;

} // namespace carving
