// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/SplitFacets.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/CoplanarTriangles.h"
#include "Helper/Base/SortedEdge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace carving::helper
{
namespace
{

using Corners = FacetCorners<3>;
using DirectedEdge = std::array<int, 2>;

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
  const auto [lower, upper] = BoxAround(points);
  return 1e-12 * (Length(lower) + Length(upper) + Length(upper - lower));
}

/** Whether a triangle has an edge in this direction. */
bool HasEdge(const Triangle& t, int from, int to)
{
  const auto corner = std::find(t.begin(), t.end(), from);
  return corner != t.end() && t[(corner - t.begin() + 1) % 3] == to;
}

/** The facets of a class, and the parts that replace them. */
struct FacetClass
{
  std::vector<int> Facets;
  int Largest = -1; ///< facet
  std::vector<Triangle> Parts;
};

std::vector<FacetClass> GroupByClass(const ResolvedMesh& surface, const std::vector<int>& classes)
{
  std::vector<FacetClass> groups;
  std::vector<double> areas; // of the largest facets
  for (int facet = 0; facet < static_cast<int>(classes.size()); ++facet)
  {
    const std::size_t index = classes[facet];
    groups.resize(std::max(groups.size(), index + 1));
    areas.resize(groups.size(), -1.0);
    const double area = TwiceArea(carving::CornersOf<3>(surface.Points, surface.Facets[facet]));
    if (area > areas[index])
    {
      areas[index] = area;
      groups[index].Largest = facet;
    }
    groups[index].Facets.push_back(facet);
  }
  return groups;
}

/** Whether a point is on the plane of the class. Roundings differ between the facets. */
bool IsOnClass(const ResolvedMesh& surface, const FacetClass& facets, int point, double rounding)
{
  const auto isOn = [&](int facet)
  {
    return IsOn(carving::CornersOf<3>(surface.Points, surface.Facets[facet]), surface.Points[point],
      rounding);
  };
  return isOn(facets.Largest) || std::any_of(facets.Facets.begin(), facets.Facets.end(), isOn);
}

/**
 * Gives all parts the direction of the largest facet. The rounded corners of a sliver may be in the
 * wrong order, so large parts decide for their neighbors.
 */
void Orient(const ResolvedMesh& surface, FacetClass& facets)
{
  std::vector<Triangle>& parts = facets.Parts;
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  const auto cornersOf = [&](const Triangle& t)
  { return carving::CornersOf<3>(surface.Points, t); };
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return TwiceArea(cornersOf(parts[a])) > TwiceArea(cornersOf(parts[b])); });
  std::multimap<DirectedEdge, std::size_t> partsOfEdges;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      partsOfEdges.emplace(SortedEdge(parts[i][k], parts[i][(k + 1) % 3]), i);
    }
  }
  const Corners3 whole = ToInexact(cornersOf(surface.Facets[facets.Largest]));
  std::vector<char> isOriented(parts.size(), 0);
  for (const std::size_t largest : order)
  {
    if (isOriented[largest])
    {
      continue;
    }
    if (!FaceAlike(whole, ToInexact(cornersOf(parts[largest]))))
    {
      parts[largest] = Flipped<3>(parts[largest]);
    }
    isOriented[largest] = 1;
    for (std::vector<std::size_t> stack = { largest }; !stack.empty();)
    {
      const Triangle t = parts[stack.back()];
      stack.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const int from = t[k], to = t[(k + 1) % 3];
        const auto [first, last] = partsOfEdges.equal_range(SortedEdge(from, to));
        for (auto neighbor = first; neighbor != last; ++neighbor)
        {
          const std::size_t i = neighbor->second;
          if (!isOriented[i])
          {
            parts[i] = HasEdge(parts[i], from, to) ? Flipped<3>(parts[i]) : parts[i];
            isOriented[i] = 1;
            stack.push_back(i);
          }
        }
      }
    }
  }
}

/** The edges of triangles without those that two triangles have in opposite directions. */
std::vector<DirectedEdge> FindBoundary(const std::vector<Triangle>& triangles)
{
  // Per edge: how many triangles have it from the lower to the higher index, less the others.
  std::map<DirectedEdge, int> counts;
  for (const Triangle& t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int from = t[i], to = t[(i + 1) % 3];
      counts[SortedEdge(from, to)] += from < to ? 1 : -1;
    }
  }
  std::vector<DirectedEdge> boundary;
  for (const auto& [edge, count] : counts)
  {
    const DirectedEdge directed = count > 0 ? edge : DirectedEdge{ edge[1], edge[0] };
    boundary.insert(boundary.end(), std::abs(count), directed);
  }
  return boundary;
}

/**
 * Follows an edge along edges that it has been split into, and removes them. Returns false if they
 * do not lead from its start to its end.
 */
bool TakeParts(const DirectedEdge& whole, const std::vector<Point>& points, double rounding,
  std::multimap<int, int>& edges)
{
  const Point &start = points[whole[0]], &end = points[whole[1]];
  double reached = 0.0;
  for (int at = whole[0]; at != whole[1];)
  {
    const auto [first, last] = edges.equal_range(at);
    const auto next = std::find_if(first, last,
      [&](const auto& edge)
      {
        const Point& p = points[edge.second];
        return edge.second == whole[1] ||
          (DistanceTo(FacetCorners<2>{ start, end }, p) <= rounding && Length(p - start) > reached);
      });
    if (next == last)
    {
      return false;
    }
    at = next->second;
    reached = Length(points[at] - start);
    edges.erase(next);
  }
  return true;
}

/**
 * Whether parts in one plane, all in the direction of the facets, cover these exactly once: that is
 * so if both have the same boundary, except for points that split its edges.
 */
bool HaveSameBoundary(const ResolvedMesh& surface, const FacetClass& facets, double rounding)
{
  std::vector<Triangle> triangles;
  for (const int facet : facets.Facets)
  {
    triangles.push_back(surface.Facets[facet]);
  }
  std::multimap<int, int> edges;
  for (const auto& [from, to] : FindBoundary(facets.Parts))
  {
    edges.emplace(from, to);
  }
  const std::vector<DirectedEdge> boundary = FindBoundary(triangles);
  return std::all_of(boundary.begin(), boundary.end(),
           [&](const DirectedEdge& whole)
           { return TakeParts(whole, surface.Points, rounding, edges); }) &&
    edges.empty();
}

} // namespace

std::vector<int> FindFacetClasses(const ResolvedMesh& surface)
{
  std::map<int, Corners3> first; // per source: the facet that gives the direction
  std::map<std::tuple<int, int, int, bool>, int> numbers;
  std::vector<int> classes;
  for (std::size_t i = 0; i < surface.Facets.size(); ++i)
  {
    const int source = surface.FacetSources[i];
    const Corners3 corners = ToInexact(carving::CornersOf<3>(surface.Points, surface.Facets[i]));
    const bool alike = FaceAlike(first.emplace(source, corners).first->second, corners);
    const auto key =
      std::make_tuple(source, surface.SignedMultiplicities[i], surface.Multiplicities[i], alike);
    classes.push_back(numbers.emplace(key, static_cast<int>(numbers.size())).first->second);
  }
  return classes;
}

std::string ReplaceByParts(
  const std::vector<FacetPart>& parts, const std::vector<int>& classes, ResolvedMesh& surface)
{
  const double rounding = RoundingOf(surface.Points);
  std::vector<FacetClass> groups = GroupByClass(surface, classes);
  ResolvedMesh split;
  for (const auto& [triangle, index] : parts)
  {
    FacetClass& group = groups[index];
    if (!std::all_of(triangle.begin(), triangle.end(),
          [&](int corner) { return IsOnClass(surface, group, corner, rounding); }))
    {
      return "the faces for triangle " + std::to_string(group.Largest) + " leave its plane";
    }
    group.Parts.push_back(triangle);
  }
  for (FacetClass& group : groups)
  {
    Orient(surface, group);
    for (const Triangle& part : group.Parts)
    {
      AppendFacet<3>(surface, group.Largest, part, split);
    }
    if (!HaveSameBoundary(surface, group, rounding))
    {
      return "the faces for triangle " + std::to_string(group.Largest) +
        " do not cover it exactly once";
    }
  }
  split.Points = std::move(surface.Points);
  split.PointSources = std::move(surface.PointSources);
  surface = std::move(split);
  return {};
}

} // namespace carving::helper
