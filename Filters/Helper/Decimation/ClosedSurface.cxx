// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/ClosedSurface.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/ExactWinding.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Resolve/Intersections.h"

#include <CGAL/determinant.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace carving::helper
{
namespace
{

/** The edge of a triangle from one corner to the next. */
struct DirectedEdge
{
  int Upper;   ///< the greater vertex
  int Corner;  ///< 3 * triangle + the corner that the edge starts at
  bool Upward; ///< the edge ends at the greater vertex

  bool operator<(const DirectedEdge& other) const
  {
    return this->Upper != other.Upper ? this->Upper < other.Upper : this->Corner < other.Corner;
  }
};

std::string Describe(const Point& p)
{
  std::ostringstream text;
  text << "(" << p[0] << ", " << p[1] << ", " << p[2] << ")";
  return text.str();
}

/** A kind of bad edges. */
struct BadEdges
{
  int Count = 0;
  std::array<int, 2> First = {};

  void Add(int lower, int upper)
  {
    if (this->Count++ == 0)
    {
      this->First = { lower, upper };
    }
  }

  std::string Describe(const ResolvedMesh& surface, const std::string& what) const
  {
    return std::to_string(this->Count) + " edges " + what + ", the first from " +
      helper::Describe(surface.Points[this->First[0]]) + " to " +
      helper::Describe(surface.Points[this->First[1]]) + ".";
  }
};

/** Pairs the edges of triangles. Sets for each corner the one where the neighbor's edge starts. */
std::string PairEdges(const ResolvedMesh& surface, std::vector<int>& partners)
{
  Buckets<DirectedEdge> edges(surface.Points.size(),
    [&](auto&& visit)
    {
      for (int corner = 0; corner < static_cast<int>(3 * surface.Facets.size()); ++corner)
      {
        const Triangle& t = surface.Facets[corner / 3];
        const int from = t[corner % 3], to = t[(corner + 1) % 3];
        visit(std::min(from, to), DirectedEdge{ std::max(from, to), corner, from < to });
      }
    });
  partners.assign(3 * surface.Facets.size(), -1);
  BadEdges open, crowded;
  for (int lower = 0; lower < edges.GetNumberOfBuckets(); ++lower)
  {
    const auto bucket = edges[lower];
    std::sort(bucket.begin(), bucket.end());
    for (auto first = bucket.begin(); first != bucket.end();)
    {
      const auto last = std::find_if(first, bucket.end(),
        [upper = first->Upper](const DirectedEdge& edge) { return edge.Upper != upper; });
      if (last - first == 2 && first[0].Upward != first[1].Upward)
      {
        partners[first[0].Corner] = first[1].Corner;
        partners[first[1].Corner] = first[0].Corner;
      }
      else
      {
        (last - first == 1 ? open : crowded).Add(lower, first->Upper);
      }
      first = last;
    }
  }
  if (open.Count > 0)
  {
    return "The surface is open: " + open.Describe(surface, "have a triangle on one side only");
  }
  return crowded.Count == 0 ? ""
                            : "The surface is not an oriented manifold: " +
      crowded.Describe(surface, "have more than two triangles, or two of opposite orientation");
}

/**
 * Replaces vertices of several fans by copies, and drops unused points. Keeps the order of points.
 */
void SplitFans(const std::vector<int>& partners, ResolvedMesh& surface)
{
  const int numberOfCorners = static_cast<int>(partners.size());
  const auto next = [](int corner) { return corner / 3 * 3 + (corner + 1) % 3; };
  DisjointSets fans(partners.size());
  for (int corner = 0; corner < numberOfCorners; ++corner)
  {
    fans.Unite(corner, next(partners[corner]));
  }
  std::vector<std::array<int, 2>> vertices; // the point, the fan
  for (int corner = 0; corner < numberOfCorners; ++corner)
  {
    if (fans.Find(corner) == corner)
    {
      vertices.push_back({ surface.Facets[corner / 3][corner % 3], corner });
    }
  }
  std::sort(vertices.begin(), vertices.end());
  ResolvedMesh split;
  split.Points.reserve(vertices.size());
  split.PointSources.reserve(vertices.size());
  std::vector<int> vertexOfFan(partners.size());
  for (const auto& [point, fan] : vertices)
  {
    vertexOfFan[fan] = static_cast<int>(split.Points.size());
    split.Points.push_back(surface.Points[point]);
    split.PointSources.push_back(surface.PointSources[point]);
  }
  for (int corner = 0; corner < numberOfCorners; ++corner)
  {
    surface.Facets[corner / 3][corner % 3] = vertexOfFan[fans.Find(corner)];
  }
  surface.Points = std::move(split.Points);
  surface.PointSources = std::move(split.PointSources);
}

/** Whether the volume that a closed surface encloses is negative. Exact. */
bool IsInsideOut(const ResolvedMesh& surface)
{
  const Point& origin = surface.Points.front();
  double sum = 0.0, size = 0.0;
  for (const auto& [a, b, c] : surface.Facets)
  {
    const std::array corners = { surface.Points[a], surface.Points[b], surface.Points[c] };
    sum += SixVolume(origin, corners[0], corners[1], corners[2]);
    size += Length(corners[0] - origin) * Length(corners[1] - origin) * Length(corners[2] - origin);
  }
  constexpr double rounding = 1e-8; // far more than that of any sum
  if (std::abs(sum) > rounding * size)
  {
    return sum < 0.0;
  }
  using Number = Exact::Exact_kernel::FT;
  Number volume = 0;
  for (const auto& [a, b, c] : surface.Facets)
  {
    const Point &p = surface.Points[a], &q = surface.Points[b], &r = surface.Points[c];
    volume += CGAL::determinant<Number>(p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]);
  }
  return volume < 0;
}

} // namespace

std::string MakeClosedSurface(ResolvedMesh& surface)
{
  if (surface.Facets.empty())
  {
    return "The surface has no triangle with an area.";
  }
  std::vector<int> partners;
  const std::string mistake = PairEdges(surface, partners);
  if (!mistake.empty())
  {
    return mistake;
  }
  SplitFans(partners, surface);
  const auto pairs = FindIntersections(surface.Points, surface.Facets);
  if (!pairs.empty())
  {
    const Triangle& t = surface.Facets[pairs.front().first];
    return "The surface crosses itself: " + std::to_string(pairs.size()) +
      " pairs of triangles meet, the first near " + Describe(surface.Points[t[0]]) + ".";
  }
  if (IsInsideOut(surface))
  {
    for (Triangle& t : surface.Facets)
    {
      t = Flipped<3>(t);
    }
  }
  return {};
}

void TurnPartsOutward(ResolvedMesh& surface)
{
  DisjointSets parts(surface.Points.size());
  for (const auto& [a, b, c] : surface.Facets)
  {
    parts.Unite(a, b);
    parts.Unite(b, c);
  }
  const auto sizeOf = [&](int facet)
  { return Size(carving::CornersOf<3>(surface.Points, surface.Facets[facet])); };
  std::map<int, int> largest; // per part: the facet
  for (int facet = 0; facet < static_cast<int>(surface.Facets.size()); ++facet)
  {
    int& known = largest.try_emplace(parts.Find(surface.Facets[facet][0]), facet).first->second;
    known = sizeOf(facet) > sizeOf(known) ? facet : known;
  }
  if (largest.size() == 1)
  {
    return;
  }
  const ExactWinding winding(surface);
  std::set<int> insideOut;
  for (const auto& [part, facet] : largest)
  {
    if (winding.InFrontOf(facet).value_or(0) < 0)
    {
      insideOut.insert(part);
    }
  }
  for (Triangle& t : surface.Facets)
  {
    t = insideOut.count(parts.Find(t[0])) > 0 ? Flipped<3>(t) : t;
  }
}

} // namespace carving::helper
