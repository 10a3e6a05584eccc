// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/SplitFacets.h"

#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/Pierce.h"

#include <algorithm>
#include <cmath>

using namespace carving;

namespace
{

using Corners = FacetCorners<3>;

Corners3 ToInexact(const Corners& t)
{
  return { ::ToInexact(t[0]), ::ToInexact(t[1]), ::ToInexact(t[2]) };
}

double Perimeter(const Corners& t)
{
  return Length(t[1] - t[0]) + Length(t[2] - t[1]) + Length(t[0] - t[2]);
}

/** A sliver hardly knows its plane: what is at an edge of it is on it in any case. */
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

double TwiceArea(const Corners& t)
{
  return Length(Cross(t[1] - t[0], t[2] - t[0]));
}

} // namespace

std::string ReplaceByParts(const std::vector<FacetPart>& parts, ResolvedMesh& surface)
{
  Point lower, upper;
  GetBounds(surface.Points, lower, upper);
  const double rounding = 1e-12 * (Length(lower) + Length(upper) + Length(upper - lower));
  ResolvedMesh split;
  std::vector<double> uncovered, allowed;
  for (const Triangle& t : surface.Facets)
  {
    const Corners corners = CornersOf<3>(surface.Points, t);
    uncovered.push_back(TwiceArea(corners));
    allowed.push_back(1e-9 * TwiceArea(corners) + rounding * Perimeter(corners));
  }
  for (const FacetPart& part : parts)
  {
    const Corners corners = CornersOf<3>(surface.Points, part.Corners),
                  whole = CornersOf<3>(surface.Points, surface.Facets[part.Parent]);
    for (const Point& corner : corners)
    {
      if (!IsOn(whole, corner, rounding))
      {
        return "the faces for triangle " + std::to_string(part.Parent) + " leave its plane";
      }
    }
    uncovered[part.Parent] -= TwiceArea(corners);
    allowed[part.Parent] += rounding * Perimeter(corners);
    split.Facets.push_back(
      FaceAlike(ToInexact(whole), ToInexact(corners)) ? part.Corners : Flipped<3>(part.Corners));
    split.FacetSources.push_back(surface.FacetSources[part.Parent]);
    split.SignedMultiplicities.push_back(surface.SignedMultiplicities[part.Parent]);
    split.Multiplicities.push_back(surface.Multiplicities[part.Parent]);
  }
  for (std::size_t i = 0; i < uncovered.size(); ++i)
  {
    if (std::abs(uncovered[i]) > allowed[i])
    {
      return "the faces for triangle " + std::to_string(i) + " are not all of it";
    }
  }
  split.Points = std::move(surface.Points);
  split.PointSources = std::move(surface.PointSources);
  surface = std::move(split);
  return {};
}
