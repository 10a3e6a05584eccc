// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/Priority.h"

#include "Core/Carving/CellDistances.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/LargePages.h"

#include <algorithm>
#include <cmath>

namespace carving
{
namespace
{

template <int D>
double LongestEdge(const CellCorners<D>& p)
{
  double longest = 0.0;
  for (int i = 0; i <= D; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      const Point edge = p[i] - p[j];
      longest = std::max(longest, Dot(edge, edge));
    }
  }
  return std::sqrt(longest);
}

/** The edge of a cube of this volume, or of a square of this area. */
template <int D>
double SizeAsLength(double size)
{
  return D == 3 ? std::cbrt(size) : std::sqrt(size);
}

/** Not finite for a flat cell. */
double Circumradius(const CellCorners<3>& p)
{
  const Point a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const double aa = Dot(a, a), bb = Dot(b, b), cc = Dot(c, c);
  const Point bc = Cross(b, c), ca = Cross(c, a), ab = Cross(a, b);
  return Length(aa * bc + bb * ca + cc * ab) / (2.0 * std::abs(Dot(a, bc)));
}

double Circumradius(const CellCorners<2>& p)
{
  return Length(p[1] - p[0]) * Length(p[2] - p[1]) * Length(p[0] - p[2]) / (4.0 * Size(p));
}

} // namespace

template <int D>
std::vector<double> ComputePriorities(
  const Decomposition<D>& mesh, PriorityMeasure measure, int threads)
{
  const double diagonal = Diagonal(mesh.Surface.Points);
  std::vector<double> priorities = MakeLarge<double>(mesh.Cells.size());
  std::vector<double> distances;
  if (measure == PriorityMeasure::EdgeDistance)
  {
    distances = MeasureDistances(mesh, threads);
  }
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const CellCorners<D> p = CornersOfCell(mesh, static_cast<int>(cell));
    switch (measure)
    {
      case PriorityMeasure::LongestEdge:
        priorities[cell] = LongestEdge<D>(p);
        break;
      case PriorityMeasure::Volume:
        priorities[cell] = Size(p);
        break;
      case PriorityMeasure::Circumradius:
      {
        const double radius = Circumradius(p);
        priorities[cell] = radius < diagonal ? radius : diagonal; // NaN becomes the diagonal, too
        break;
      }
      case PriorityMeasure::EdgeVolume:
        priorities[cell] = std::sqrt(LongestEdge<D>(p) * SizeAsLength<D>(Size(p)));
        break;
      case PriorityMeasure::EdgeDistance:
        priorities[cell] = std::cbrt(LongestEdge<D>(p) * distances[cell] * distances[cell]);
        break;
    }
  }
  return priorities;
}

template std::vector<double> ComputePriorities<2>(const Decomposition<2>&, PriorityMeasure, int);
template std::vector<double> ComputePriorities<3>(const Decomposition<3>&, PriorityMeasure, int);

template <int D>
double PriorityAsLength(double priority, PriorityMeasure measure)
{
  switch (measure)
  {
    case PriorityMeasure::Volume:
      return SizeAsLength<D>(priority);
    case PriorityMeasure::Circumradius:
      return 2.0 * priority;
    default:
      return priority;
  }
}

template double PriorityAsLength<2>(double, PriorityMeasure);
template double PriorityAsLength<3>(double, PriorityMeasure);

} // namespace carving
