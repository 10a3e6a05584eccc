// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Snap.h"

#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Intersections.h"
#include "Helper/Resolve/Resolve.h"

#include <algorithm>
#include <cmath>

namespace carving::helper
{
namespace
{

/** A coordinate so large that a double cannot be off the grid stays as it is. */
double Round(double coordinate, double spacing)
{
  constexpr double exactIntegers = 9007199254740992.0; // 2^53
  const double steps = coordinate / spacing;
  return std::abs(steps) < exactIntegers ? std::round(steps) * spacing : coordinate;
}

Point Rounded(Point p, double spacing)
{
  for (double& coordinate : p)
  {
    coordinate = Round(coordinate, spacing);
  }
  return p;
}

/** Returns the largest distance by which a point moves. */
double Round(std::vector<Point>& points, double spacing)
{
  double farthest = 0.0;
  for (Point& p : points)
  {
    const Point from = p;
    p = Rounded(p, spacing);
    farthest = std::max(farthest, Length(p - from));
  }
  return farthest;
}

/** The largest distance of a corner from the given triangle that its triangle is a part of. */
double DistanceFromSources(const ResolvedMesh& given, const ResolvedMesh& mesh)
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < mesh.Facets.size(); ++i)
  {
    const auto source =
      std::lower_bound(given.FacetSources.begin(), given.FacetSources.end(), mesh.FacetSources[i]);
    const FacetCorners<3> whole =
      carving::CornersOf<3>(given.Points, given.Facets[source - given.FacetSources.begin()]);
    for (const int corner : mesh.Facets[i])
    {
      farthest = std::max(farthest, DistanceTo(whole, mesh.Points[corner]));
    }
  }
  return farthest;
}

} // namespace

double GridSpacing(double tolerance)
{
  // A point in the middle of a cube of the grid moves by half the cube's diagonal.
  return std::exp2(std::floor(std::log2(tolerance * 2.0 / std::sqrt(3.0))));
}

std::string Snap(const ResolvedMesh& given, double spacing, const Progress& progress,
  double maximumPairs, SnappedMesh& snapped)
{
  constexpr int maximumRounds = 10;
  snapped = {};
  ResolvedMesh& mesh = snapped.Mesh;
  mesh = given;
  snapped.Distance = Round(mesh.Points, spacing);
  mesh = Clean(mesh);
  std::string mistake = Resolve(mesh, snapped.IntersectingPairs, progress, maximumPairs);
  int left = snapped.IntersectingPairs;
  for (int round = 0; mistake.empty() && left > 0; ++round)
  {
    const int before = left;
    Round(mesh.Points, spacing);
    mesh = Clean(mesh);
    mistake = Resolve(mesh, left, progress, maximumPairs);
    if (mistake.empty() && left > 0 && (round == maximumRounds || (round > 0 && left >= before)))
    {
      mistake = "after " + std::to_string(round + 1) + " rounds " + std::to_string(left) +
        " pairs of triangles still cross each other";
    }
  }
  snapped.Distance = std::max(snapped.Distance, DistanceFromSources(given, mesh));
  return mistake;
}

std::string SnapTouching(const ResolvedMesh& given, double tolerance, const Progress& progress,
  double maximumPairs, SnappedMesh& snapped)
{
  snapped = {};
  ResolvedMesh& mesh = snapped.Mesh;
  mesh = given;
  double again = 0.0; // the distance by which given points move at the second time
  std::string mistake = ResolveTouching(
    mesh, tolerance, snapped.Distance, snapped.IntersectingPairs, progress, maximumPairs);
  if (mistake.empty())
  {
    // TetGen takes points that roundings alone have moved off a plane as on it at one time and off
    // it at another, and fails.
    const double spacing = GridSpacing(tolerance);
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      if (mesh.PointSources[i] < 0)
      {
        mesh.Points[i] = Rounded(mesh.Points[i], spacing);
      }
    }
    mesh = Clean(mesh);
    if (!FindIntersections(mesh.Points, mesh.Facets).empty())
    {
      int left = 0;
      mistake = ResolveTouching(mesh, tolerance, again, left, progress, maximumPairs);
    }
  }
  snapped.Distance = std::max(snapped.Distance + again, DistanceFromSources(given, mesh));
  return mistake;
}

} // namespace carving::helper
