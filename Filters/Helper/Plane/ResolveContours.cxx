// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Plane/ResolveContours.h"

#include "Helper/Base/Cleaning.h"
#include "Helper/Base/PlaneTriangulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace carving::helper
{
namespace
{

using Vertex = PlaneTriangulation::Vertex_handle;
using Edge = std::array<int, 2>;

void AppendEdge(const Contours& from, std::size_t i, const Edge& ends, Contours& to)
{
  AppendFacet<2>(from, i, ends, to);
  to.Initial.push_back(from.Initial[i]);
}

/** Merges edge i of `from` into the edge `into` of `to`, which has the same ends. */
void MergeEdge(
  const Contours& from, std::size_t i, const Edge& ends, Contours& to, std::size_t into)
{
  const int sign = SameDirection<2>(ends, to.Facets[into]) ? 1 : -1;
  if (to.Multiplicities[into] == 0)
  {
    // An edge of C0 only gets its direction and source from the first edge of M.
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

/** The third coordinate of a point on an edge. */
double Interpolate(const Point& a, const Point& b, const Point& place)
{
  const int axis = std::abs(b[0] - a[0]) > std::abs(b[1] - a[1]) ? 0 : 1;
  const double t = (place[axis] - a[axis]) / (b[axis] - a[axis]);
  return a[2] == b[2] ? a[2] : (1.0 - t) * a[2] + t * b[2];
}

/** Whether two points may differ by a few roundings only. */
bool AreNear(const Point& a, const Point& b)
{
  constexpr double share = 1e-14;
  const double distance = std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1]));
  return distance <= share * std::max(std::abs(a[0]), std::abs(a[1]));
}

/**
 * Returns the index of a point at a vertex on an edge: of a new point or, with `snap`, of a
 * neighbor that is near.
 */
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

/** Makes one round of splitting. Returns the number of points at which edges are split. */
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
  std::vector<int> splitPoints;
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
    splitPoints.insert(splitPoints.end(), chain.begin() + 1, chain.end() - 1);
    for (std::size_t k = 1; k < chain.size(); ++k)
    {
      AppendEdge(contours, i, { chain[k - 1], chain[k] }, result);
    }
  }
  std::sort(splitPoints.begin(), splitPoints.end());
  return static_cast<int>(
    std::unique(splitPoints.begin(), splitPoints.end()) - splitPoints.begin());
}

} // namespace

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
  const std::vector<int> first = FirstEqualPoints<2>(contours.Points);
  std::map<std::pair<int, int>, std::size_t> edges;
  for (std::size_t i = 0; i < contours.Facets.size(); ++i)
  {
    const Edge ends = { first[contours.Facets[i][0]], first[contours.Facets[i][1]] };
    if (ends[0] == ends[1])
    {
      continue;
    }
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
  TakeUsedPoints<2>(contours, result);
  return result;
}

std::string Resolve(Contours& contours, int& splitPoints, const Progress& progress)
{
  // One round suffices for nearly all contours. The limit ends cases in which rounding creates ever
  // more intersections.
  constexpr int maximumRounds = 10;
  // Edges that nearly coincide intersect again next to every rounded point, without end. After
  // these rounds, points that differ by roundings only become one.
  constexpr int exactRounds = 3;
  for (int round = 0; round <= maximumRounds; ++round)
  {
    Contours pieces;
    const int found = Split(contours, round >= exactRounds, pieces, progress);
    splitPoints = round == 0 ? found : splitPoints;
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

} // namespace carving::helper
