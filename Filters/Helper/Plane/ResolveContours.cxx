// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Plane/ResolveContours.h"

#include "Helper/Base/Kernels.h"

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

using namespace carving;

namespace
{

using Vertex = PlaneTriangulation::Vertex_handle;
using Edge = std::array<int, 2>;

bool Equal(const Point& a, const Point& b)
{
  return a[0] == b[0] && a[1] == b[1];
}

/** For every point the first one at the same place. */
std::vector<int> FirstEqualPoints(const std::vector<Point>& points)
{
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    {
      const Point &p = points[a], &q = points[b];
      return p[0] != q[0] ? p[0] < q[0] : p[1] != q[1] ? p[1] < q[1] : a < b;
    });
  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool equal = i > 0 && Equal(points[order[i]], points[order[i - 1]]);
    first[order[i]] = equal ? first[order[i - 1]] : order[i];
  }
  return first;
}

void AppendEdge(const Contours& from, std::size_t i, const Edge& ends, Contours& to)
{
  AppendFacet<2>(from, i, ends, to);
  to.Initial.push_back(from.Initial[i]);
}

/** Merges an edge of one set into an edge with the same ends of another. */
void MergeEdge(
  const Contours& from, std::size_t i, const Edge& ends, Contours& to, std::size_t into)
{
  const int sign = SameDirection<2>(ends, to.Facets[into]) ? 1 : -1;
  if (to.Multiplicities[into] == 0) // so far only of C0: the first edge of M decides
  {
    to.Facets[into] = ends;
    to.FacetSources[into] = from.FacetSources[i];
    to.SignedMultiplicities[into] = from.SignedMultiplicities[i];
  }
  else
  {
    to.SignedMultiplicities[into] += sign * from.SignedMultiplicities[i];
  }
  to.Multiplicities[into] += from.Multiplicities[i];
  to.Initial[into] = to.Initial[into] || from.Initial[i];
}

/** The third coordinate at a place on an edge. */
double Interpolate(const Point& a, const Point& b, const Point& place)
{
  const int axis = std::abs(b[0] - a[0]) > std::abs(b[1] - a[1]) ? 0 : 1;
  const double t = (place[axis] - a[axis]) / (b[axis] - a[axis]);
  return a[2] == b[2] ? a[2] : (1.0 - t) * a[2] + t * b[2];
}

/** Whether a few roundings can lead from one place to the other. */
bool AreNear(const Point& a, const Point& b)
{
  constexpr double share = 1e-14;
  const double distance = std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1]));
  return distance <= share * std::max(std::abs(a[0]), std::abs(a[1]));
}

/** The new point that a vertex on an edge is; with `snap` an old one next to it, if that is near. */
int AddPoint(const Contours& contours, std::size_t edge, const PlaneTriangulation& triangulation,
  Vertex vertex, bool snap, Contours& result)
{
  const auto& exact = vertex->point();
  Point place = { CGAL::to_double(CGAL::exact(exact.x())), CGAL::to_double(CGAL::exact(exact.y())),
    0.0 };
  auto neighbor = triangulation.incident_vertices(vertex);
  const auto first = neighbor;
  do
  {
    const int index = triangulation.is_infinite(neighbor) ? -1 : neighbor->info().Value;
    if (snap && index >= 0 && AreNear(place, result.Points[index]))
    {
      return index;
    }
  } while (++neighbor != first);
  const auto& [from, to] = contours.Facets[edge];
  place[2] = Interpolate(contours.Points[from], contours.Points[to], place);
  result.Points.push_back(place);
  result.PointSources.push_back(-1);
  return static_cast<int>(result.Points.size()) - 1;
}

/** One round: the edges in pieces. Returns the number of places at which any had to be split. */
int Split(const Contours& contours, bool snap, Contours& result, const Progress& progress)
{
  PlaneTriangulation triangulation;
  const std::vector<Vertex> vertices = InsertPoints(contours.Points, triangulation);
  std::vector<PlaneTriangulation::Constraint_id> constraints;
  constraints.reserve(contours.Facets.size());
  for (const auto& [from, to] : contours.Facets)
  {
    GoOn(progress, static_cast<double>(constraints.size()) / contours.Facets.size());
    constraints.push_back(triangulation.insert_constraint(vertices[from], vertices[to]));
  }
  result.Points = contours.Points;
  result.PointSources = contours.PointSources;
  std::vector<int> meetings;
  for (std::size_t i = 0; i < constraints.size(); ++i)
  {
    const auto end = triangulation.vertices_in_constraint_end(constraints[i]);
    std::vector<int> chain;
    for (auto vertex = triangulation.vertices_in_constraint_begin(constraints[i]); vertex != end;
         ++vertex)
    {
      PointIndex& index = (*vertex)->info();
      index.Value =
        index.Value < 0 ? AddPoint(contours, i, triangulation, *vertex, snap, result) : index.Value;
      chain.push_back(index.Value);
    }
    if (chain.front() != contours.Facets[i][0])
    {
      std::reverse(chain.begin(), chain.end());
    }
    meetings.insert(meetings.end(), chain.begin() + 1, chain.end() - 1);
    for (std::size_t k = 1; k < chain.size(); ++k)
    {
      AppendEdge(contours, i, { chain[k - 1], chain[k] }, result);
    }
  }
  std::sort(meetings.begin(), meetings.end());
  return static_cast<int>(std::unique(meetings.begin(), meetings.end()) - meetings.begin());
}

} // namespace

std::vector<Vertex> InsertInOrder(
  const std::vector<PlaneKernel::Point_2>& places, PlaneTriangulation& triangulation)
{
  std::vector<Inexact::Point_2> rounded;
  rounded.reserve(places.size());
  for (const auto& place : places)
  {
    rounded.emplace_back(CGAL::to_double(place.x()), CGAL::to_double(place.y()));
  }
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  using Map = CGAL::Pointer_property_map<Inexact::Point_2>::type;
  CGAL::spatial_sort(order.begin(), order.end(),
    CGAL::Spatial_sort_traits_adapter_2<Inexact, Map>(CGAL::make_property_map(rounded)));
  std::vector<Vertex> vertices(places.size());
  PlaneTriangulation::Face_handle hint;
  for (const std::size_t i : order)
  {
    vertices[i] = triangulation.insert(places[i], hint);
    hint = vertices[i]->face();
  }
  return vertices;
}

std::vector<Vertex> InsertPoints(
  const std::vector<Point>& points, PlaneTriangulation& triangulation)
{
  std::vector<PlaneKernel::Point_2> places;
  places.reserve(points.size());
  for (const Point& point : points)
  {
    places.emplace_back(point[0], point[1]);
  }
  const std::vector<Vertex> vertices = InsertInOrder(places, triangulation);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    vertices[i]->info().Value = static_cast<int>(i);
  }
  return vertices;
}

Contours AsContours(const ContourSet& given, bool initial)
{
  Contours contours;
  contours.Points = given.Points;
  contours.PointSources.assign(given.Points.size(), -1);
  contours.Facets = given.Edges;
  contours.FacetSources.resize(given.Edges.size());
  std::iota(contours.FacetSources.begin(), contours.FacetSources.end(), 0);
  if (!initial)
  {
    std::iota(contours.PointSources.begin(), contours.PointSources.end(), 0);
  }
  contours.SignedMultiplicities.assign(given.Edges.size(), initial ? 0 : 1);
  contours.Multiplicities.assign(given.Edges.size(), initial ? 0 : 1);
  contours.Initial.assign(given.Edges.size(), initial);
  return contours;
}

void Append(const Contours& other, Contours& contours)
{
  const int first = static_cast<int>(contours.Points.size());
  contours.Points.insert(contours.Points.end(), other.Points.begin(), other.Points.end());
  contours.PointSources.insert(
    contours.PointSources.end(), other.PointSources.begin(), other.PointSources.end());
  for (std::size_t i = 0; i < other.Facets.size(); ++i)
  {
    AppendEdge(other, i, { first + other.Facets[i][0], first + other.Facets[i][1] }, contours);
  }
}

Contours Clean(const Contours& contours)
{
  Contours result;
  std::vector<int> newIndex = FirstEqualPoints(contours.Points);
  std::vector<char> used(contours.Points.size(), 0);
  std::map<std::pair<int, int>, std::size_t> edges;
  for (std::size_t i = 0; i < contours.Facets.size(); ++i)
  {
    const Edge ends = { newIndex[contours.Facets[i][0]], newIndex[contours.Facets[i][1]] };
    if (ends[0] == ends[1])
    {
      continue;
    }
    used[ends[0]] = used[ends[1]] = 1;
    const auto [found, isNew] = edges.try_emplace(std::minmax(ends[0], ends[1]), edges.size());
    if (isNew)
    {
      AppendEdge(contours, i, ends, result);
    }
    else
    {
      MergeEdge(contours, i, ends, result, found->second);
    }
  }
  for (std::size_t i = 0; i < contours.Points.size(); ++i)
  {
    if (used[i])
    {
      newIndex[i] = static_cast<int>(result.Points.size());
      result.Points.push_back(contours.Points[i]);
      result.PointSources.push_back(contours.PointSources[i]);
    }
  }
  for (Edge& edge : result.Facets)
  {
    edge = { newIndex[edge[0]], newIndex[edge[1]] };
  }
  return result;
}

std::string Resolve(Contours& contours, int& meetings, const Progress& progress)
{
  // Nearly all contours are clean after one round; the limit ends those that rounding keeps dirty.
  constexpr int maximumRounds = 10;
  // Edges that nearly coincide meet anew next to every point that is rounded, without end: then
  // points that only rounding has moved apart become one.
  constexpr int exactRounds = 3;
  for (int round = 0; round <= maximumRounds; ++round)
  {
    Contours pieces;
    const int found = Split(contours, round >= exactRounds, pieces, progress);
    meetings = round == 0 ? found : meetings;
    if (found == 0)
    {
      return {};
    }
    contours = Clean(pieces);
  }
  return "After " + std::to_string(maximumRounds) +
    " rounds of splitting, edges still cross each other: the contours are too intricate for double "
    "precision.";
}
