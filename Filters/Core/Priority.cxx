// SPDX-License-Identifier: BSD-3-Clause
#include "Priority.h"

#include "Vector.h"

#include <algorithm>
#include <cmath>

namespace carving
{
namespace
{

using Corners = std::array<Point, 4>;

double LongestEdge(const Corners& p)
{
  double longest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      const Point edge = p[i] - p[j];
      longest = std::max(longest, Dot(edge, edge));
    }
  }
  return std::sqrt(longest);
}

double Volume(const Corners& p)
{
  return std::max(0.0, SixVolume(p[0], p[1], p[2], p[3]) / 6.0);
}

double Circumradius(const Corners& p, double limit)
{
  const Point a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const double aa = Dot(a, a), bb = Dot(b, b), cc = Dot(c, c);
  const Point bc = Cross(b, c), ca = Cross(c, a), ab = Cross(a, b);
  Point toCenter;
  for (int i = 0; i < 3; ++i)
  {
    toCenter[i] = aa * bc[i] + bb * ca[i] + cc * ab[i];
  }
  const double radius = Length(toCenter) / (2.0 * std::abs(Dot(a, bc)));
  return radius < limit ? radius : limit; // NaN and infinity of flat tetrahedra become the limit
}

} // namespace

std::vector<double> ComputePriorities(const Tetrahedralization& mesh, PriorityMeasure measure)
{
  const double diagonal = Diagonal(mesh.Surface.Points);
  std::vector<double> priorities(mesh.Cells.size());
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    Corners p;
    for (int i = 0; i < 4; ++i)
    {
      p[i] = mesh.Surface.Points[mesh.Cells[cell][i]];
    }
    switch (measure)
    {
      case PriorityMeasure::LongestEdge:
        priorities[cell] = LongestEdge(p);
        break;
      case PriorityMeasure::Volume:
        priorities[cell] = Volume(p);
        break;
      case PriorityMeasure::Circumradius:
        priorities[cell] = Circumradius(p, diagonal);
        break;
      case PriorityMeasure::EdgeVolume:
        priorities[cell] = std::sqrt(LongestEdge(p) * std::cbrt(Volume(p)));
        break;
    }
  }
  return priorities;
}

double PriorityAsLength(double priority, PriorityMeasure measure)
{
  switch (measure)
  {
    case PriorityMeasure::Volume:
      return std::cbrt(priority);
    case PriorityMeasure::Circumradius:
      return 2.0 * priority;
    default:
      return priority;
  }
}

double Diagonal(const std::vector<Point>& points)
{
  if (points.empty())
  {
    return 0.0;
  }
  Point lower, upper;
  GetBounds(points, lower, upper);
  return Length(upper - lower);
}

} // namespace carving
