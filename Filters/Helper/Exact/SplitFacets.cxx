// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/SplitFacets.h"

#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/CoplanarTriangles.h"

#include <algorithm>
#include <cmath>

namespace carving::helper
{
namespace
{

using Corners = FacetCorners<3>;

Corners3 AsInexact(const Corners& t)
{
  return { ToInexact(t[0]), ToInexact(t[1]), ToInexact(t[2]) };
}

double Perimeter(const Corners& t)
{
  return Length(t[1] - t[0]) + Length(t[2] - t[1]) + Length(t[0] - t[2]);
}

double TwiceArea(const Corners& t)
{
  return Length(Cross(t[1] - t[0], t[2] - t[0]));
}

/**
 * Whether a point is on a triangle's plane, except for rounding. The normal of a sliver is
 * inaccurate, so a point on an edge always is.
 */
bool IsOn(const Corners& t, const Point& p, double rounding)
{
  const Point normal = Cross(t[1] - t[0], t[2] - t[0]);
  bool on = std::abs(Dot(p - t[0], normal)) <= rounding * Length(normal);
  for (int i = 0; i < 3; ++i)
  {
    on = on || DistanceTo(FacetCorners<2>{ t[i], t[(i + 1) % 3] }, p) <= rounding;
  }
  return on;
}

/** A bound on the rounding error of distances between the points. */
double RoundingOf(const std::vector<Point>& points)
{
  Point lower, upper;
  GetBounds(points, lower, upper);
  return 1e-12 * (Length(lower) + Length(upper) + Length(upper - lower));
}

} // namespace

std::string ReplaceByParts(const std::vector<FacetPart>& parts, ResolvedMesh& surface)
{
  const double rounding = RoundingOf(surface.Points);
  ResolvedMesh split;
  std::vector<double> uncovered, allowed; // twice an area, one entry per facet
  for (const Triangle& t : surface.Facets)
  {
    const Corners corners = CornersOf<3>(surface.Points, t);
    uncovered.push_back(TwiceArea(corners));
    allowed.push_back(1e-9 * TwiceArea(corners) + rounding * Perimeter(corners));
  }
  for (const auto& [triangle, parent] : parts)
  {
    const Corners corners = CornersOf<3>(surface.Points, triangle),
                  whole = CornersOf<3>(surface.Points, surface.Facets[parent]);
    if (!std::all_of(corners.begin(), corners.end(),
          [&](const Point& corner) { return IsOn(whole, corner, rounding); }))
    {
      return "the faces for triangle " + std::to_string(parent) + " leave its plane";
    }
    uncovered[parent] -= TwiceArea(corners);
    allowed[parent] += rounding * Perimeter(corners);
    AppendFacet<3>(surface, parent,
      FaceAlike(AsInexact(whole), AsInexact(corners)) ? triangle : Flipped<3>(triangle), split);
  }
  for (std::size_t i = 0; i < uncovered.size(); ++i)
  {
    if (std::abs(uncovered[i]) > allowed[i])
    {
      return "the faces for triangle " + std::to_string(i) + " do not cover it exactly once";
    }
  }
  split.Points = std::move(surface.Points);
  split.PointSources = std::move(surface.PointSources);
  surface = std::move(split);
  return {};
}

} // namespace carving::helper
