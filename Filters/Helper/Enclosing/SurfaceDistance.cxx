// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/SurfaceDistance.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <vector>

namespace carving::helper
{
namespace
{

using Corners = SurfaceDistance::Corners;

Point Centroid(const Corners& t)
{
  return (t[0] + t[1] + t[2]) / 3.0;
}

constexpr double Accuracy = 0.05;

/**
 * Some fifty times the distance between neighboring values of the farthest coordinate. Quarters of
 * triangles below this length need not be smaller than the triangles.
 */
double FindResolution(const std::vector<Point>& points)
{
  double farthest = 0.0;
  for (const Point& p : points)
  {
    farthest = std::max(farthest, Length(p));
  }
  return 1e-14 * farthest;
}

double RadiusAround(const Point& centroid, const Corners& t)
{
  double radius = 0.0;
  for (const Point& corner : t)
  {
    radius = std::max(radius, Length(corner - centroid));
  }
  return radius;
}

void PushQuarters(const Corners& t, std::vector<Corners>& stack)
{
  const Point a = Between(t[1], t[2], 0.5), b = Between(t[2], t[0], 0.5),
              c = Between(t[0], t[1], 0.5);
  stack.push_back({ t[0], c, b });
  stack.push_back({ t[1], a, c });
  stack.push_back({ t[2], b, a });
  stack.push_back({ a, b, c });
}

} // namespace

SurfaceDistance::SurfaceDistance(const ResolvedMesh& surface)
  : Surface(std::make_shared<const FacetTree<3>>(surface))
  , Resolution(FindResolution(surface.Points))
{
}

double SurfaceDistance::ToTriangle(int triangle, const Point& point) const
{
  return DistanceTo(this->Surface->GetItems().CornersOf(triangle), point);
}

bool SurfaceDistance::HasWithin(const Point& point, double distance)
{
  if (distance <= 0.0)
  {
    return false;
  }
  if (this->ToTriangle(this->Last, point) <= distance)
  {
    return true;
  }
  bool found = false;
  const double limit = distance * distance;
  this->Surface->ForEachNear(point, limit,
    [&](int triangle)
    {
      found = this->ToTriangle(triangle, point) <= distance;
      this->Last = found ? triangle : this->Last;
      return found ? 0.0 : limit; // 0 ends the search
    });
  return found;
}

double SurfaceDistance::Distance(const Point& point)
{
  const FacetTree<3>::Closest closest = this->Surface->Find(point, 0.0, this->Last);
  this->Last = std::max(closest.Item, 0);
  return closest.Distance;
}

/**
 * Whether all of a triangle is within a distance of the triangle of M found last. The points within
 * the distance are a convex set, so the corners decide.
 */
bool SurfaceDistance::LastHasWithin(const Corners& triangle, double distance) const
{
  return std::all_of(triangle.begin(), triangle.end(),
    [&](const Point& p) { return this->ToTriangle(this->Last, p) <= distance; });
}

// The distance from M changes by no more than the distance between two points, so its value at the
// centroid of a triangle bounds it on the whole triangle. Where the bound is too weak, the triangle
// is quartered.

bool SurfaceDistance::IsWithin(const Corners& triangle, double distance)
{
  std::vector<Corners> stack = { triangle };
  while (!stack.empty())
  {
    const Corners t = stack.back();
    stack.pop_back();
    const Nearness nearness = this->FindNearness(t, distance);
    if (nearness == Nearness::CentroidIsFar)
    {
      return false;
    }
    if (nearness == Nearness::CentroidIsNear)
    {
      PushQuarters(t, stack);
    }
  }
  return true;
}

SurfaceDistance::Nearness SurfaceDistance::FindNearness(const Corners& t, double distance)
{
  const Point centroid = Centroid(t);
  const double radius = RadiusAround(centroid, t);
  const bool isSmall = radius <= std::max(Accuracy * distance, this->Resolution);
  const double enough = isSmall ? distance : distance - radius; // at the centroid, for all points
  Nearness result = Nearness::CentroidIsFar;
  const auto visit = [&](int item)
  {
    const double here = this->ToTriangle(item, centroid);
    if (here <= distance)
    {
      this->Last = item;
      result = here <= enough || this->LastHasWithin(t, distance) ? Nearness::AllIsNear
                                                                  : Nearness::CentroidIsNear;
    }
    if (result == Nearness::CentroidIsFar)
    {
      return distance * distance;
    }
    return result == Nearness::AllIsNear || enough <= 0.0 ? 0.0 : enough * enough; // 0: no more
  };
  if (distance > 0.0 && visit(this->Last) > 0.0)
  {
    const bool isNear = result == Nearness::CentroidIsNear;
    this->Surface->ForEachNear(centroid, isNear ? enough * enough : distance * distance, visit);
  }
  return result;
}

double SurfaceDistance::Farthest(const Corners& triangle, double atLeast)
{
  double farthest = atLeast;
  std::vector<Corners> stack = { triangle };
  while (!stack.empty())
  {
    const Corners t = stack.back();
    stack.pop_back();
    const Point centroid = Centroid(t);
    const double radius = RadiusAround(centroid, t);
    if (this->LastHasWithin(t, (1.0 + Accuracy) * farthest) ||
      this->HasWithin(centroid, (1.0 + Accuracy) * farthest - radius))
    {
      continue; // cheaper than the search for the closest triangle
    }
    const double distance = this->Distance(centroid);
    farthest = std::max(farthest, distance);
    const double limit = (1.0 + Accuracy) * farthest;
    if (radius > this->Resolution && distance + radius > limit && !this->LastHasWithin(t, limit))
    {
      PushQuarters(t, stack);
    }
  }
  return farthest;
}

} // namespace carving::helper
