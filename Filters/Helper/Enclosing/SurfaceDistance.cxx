// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Enclosing/SurfaceDistance.h"

#include "Core/Mesh/Vector.h"

// CGAL 6 deprecates these names of CGAL 5, which has no others.
#define CGAL_NO_DEPRECATION_WARNINGS
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace carving::helper
{
namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Corners = SurfaceDistance::Corners;

Kernel::Point_3 ToKernel(const Point& p)
{
  return { p[0], p[1], p[2] };
}

Point Middle(const Point& a, const Point& b)
{
  return (a + b) / 2.0;
}

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
  const Point a = Middle(t[1], t[2]), b = Middle(t[2], t[0]), c = Middle(t[0], t[1]);
  stack.push_back({ t[0], c, b });
  stack.push_back({ t[1], a, c });
  stack.push_back({ t[2], b, a });
  stack.push_back({ a, b, c });
}

} // namespace

/** The triangles of M in a tree. */
class SurfaceDistance::Tree
{
public:
  explicit Tree(const ResolvedMesh& surface)
  {
    for (const auto& [a, b, c] : surface.Facets)
    {
      this->All.emplace_back(
        ToKernel(surface.Points[a]), ToKernel(surface.Points[b]), ToKernel(surface.Points[c]));
    }
    this->Boxes.rebuild(this->All.cbegin(), this->All.cend());
    this->Boxes.build(); // now, not at the first question, which a thread asks
  }

  double SquaredDistance(const Point& point, int triangle) const
  {
    return CGAL::squared_distance(ToKernel(point), this->All[triangle]);
  }

  /** Any triangle within a distance of a point; -1: none. */
  int FindWithin(const Point& point, double distance) const
  {
    return this->Find(point, { distance * distance, false });
  }

  /** The closest triangle, if one is closer than a given one, or else the given one. */
  int FindClosest(const Point& point, int given) const
  {
    const int found = this->Find(point, { this->SquaredDistance(point, given), true });
    return found < 0 ? given : found;
  }

private:
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;

  /** Searches for a triangle within a distance of a point: for any triangle, or for the closest. */
  struct Search
  {
    double SquaredDistance;
    bool ForClosest;
    const Kernel::Triangle_3* Found = nullptr;

    bool go_further() const
    {
      return this->ForClosest || this->Found == nullptr;
    }
    void intersection(const Kernel::Point_3& p, const Primitive& primitive)
    {
      const Kernel::Triangle_3& triangle = *primitive.id();
      const double squared = CGAL::squared_distance(p, triangle);
      if (squared <= this->SquaredDistance)
      {
        this->Found = &triangle;
        this->SquaredDistance = this->ForClosest ? squared : this->SquaredDistance;
      }
    }
    bool do_intersect(const Kernel::Point_3& p, const CGAL::AABB_node<Traits>& node) const
    {
      double squared = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        const double beyond =
          std::max({ node.bbox().min(i) - p[i], p[i] - node.bbox().max(i), 0.0 });
        squared += beyond * beyond;
      }
      return squared <= this->SquaredDistance;
    }
  };

  int Find(const Point& point, Search search) const
  {
    this->Boxes.traversal(ToKernel(point), search);
    return search.Found ? static_cast<int>(search.Found - this->All.data()) : -1;
  }

  Triangles All;
  CGAL::AABB_tree<Traits> Boxes;
};

SurfaceDistance::SurfaceDistance(const ResolvedMesh& surface)
  : Surface(std::make_shared<const Tree>(surface))
  , Resolution(FindResolution(surface.Points))
{
}

bool SurfaceDistance::HasWithin(const Point& point, double distance)
{
  if (distance <= 0.0)
  {
    return false;
  }
  if (this->Surface->SquaredDistance(point, this->Last) <= distance * distance)
  {
    return true;
  }
  const int found = this->Surface->FindWithin(point, distance);
  this->Last = found < 0 ? this->Last : found;
  return found >= 0;
}

double SurfaceDistance::Distance(const Point& point)
{
  this->Last = this->Surface->FindClosest(point, this->Last);
  return std::sqrt(this->Surface->SquaredDistance(point, this->Last));
}

/**
 * Whether all of a triangle is within a distance of the triangle of M found last. The points within
 * the distance are a convex set, so the corners decide.
 */
bool SurfaceDistance::LastHasWithin(const Corners& triangle, double distance) const
{
  return std::all_of(triangle.begin(), triangle.end(),
    [&](const Point& p)
    { return this->Surface->SquaredDistance(p, this->Last) <= distance * distance; });
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
    const Point centroid = Centroid(t);
    const double radius = RadiusAround(centroid, t);
    if (!this->HasWithin(centroid, distance))
    {
      return false;
    }
    if (radius > std::max(Accuracy * distance, this->Resolution) &&
      !this->LastHasWithin(t, distance) && !this->HasWithin(centroid, distance - radius))
    {
      PushQuarters(t, stack);
    }
  }
  return true;
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
