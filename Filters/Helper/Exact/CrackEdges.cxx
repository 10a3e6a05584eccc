// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/CrackEdges.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/SortUnique.h"
#include "Core/Mesh/Vector.h"
#include "Core/Solid/Cracks.h"
#include "Core/Solid/Winding.h"
#include "Helper/Base/SortedEdge.h"
#include "Helper/Exact/EdgeSplitter.h"
#include "Helper/Resolve/NearPairs.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

namespace carving::helper
{
namespace
{

using Edge = std::array<int, 2>;
using Edges = std::vector<Edge>; // in ascending order

/** A place at which an edge passes through a crack. */
struct Passage
{
  double Share;    ///< of the way from the lower end
  double Distance; ///< from an edge of the crack
};

using Passages = std::map<Edge, Passage>;

/** All edges of facets, once for each facet. */
Edges FindEdges(const ResolvedMesh& mesh)
{
  Edges edges;
  edges.reserve(3 * mesh.Facets.size());
  for (const Triangle& t : mesh.Facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.push_back(SortedEdge(t[i], t[(i + 1) % 3]));
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/** The edges that occur an odd number of times. */
Edges FindRims(const Edges& edges)
{
  Edges rims;
  for (auto first = edges.begin(), last = first; first != edges.end(); first = last)
  {
    last = std::upper_bound(first, edges.end(), *first);
    if ((last - first) % 2 != 0)
    {
      rims.push_back(*first);
    }
  }
  return rims;
}

/** The share of the way along an edge at which it is closest to a point. */
double ShareAt(const std::vector<Point>& points, const Edge& edge, const Point& p)
{
  const Point along = points[edge[1]] - points[edge[0]];
  return std::clamp(Dot(along, p - points[edge[0]]) / Dot(along, along), 0.0, 1.0);
}

Point PointAt(const std::vector<Point>& points, const Edge& edge, double share)
{
  return Between(points[edge[0]], points[edge[1]], share);
}

/** The rims that an end of another rim is close to. */
Edges FindCracks(const std::vector<Point>& points, const Edges& rims, double width)
{
  std::vector<std::array<int, 1>> ends;
  for (const auto& [a, b] : rims)
  {
    ends.push_back({ a });
    ends.push_back({ b });
  }
  SortUnique(ends);
  Edges cracks;
  VisitPairs(WidenedBoxes(points, ends, width), WidenedBoxes(points, rims, 0.0),
    [&](int i, int k)
    {
      const int end = ends[i][0];
      const Edge& rim = rims[k];
      const Point& p = points[end];
      if (end != rim[0] && end != rim[1] &&
        Length(PointAt(points, rim, ShareAt(points, rim, p)) - p) <= width)
      {
        cracks.push_back(rim);
      }
    });
  SortUnique(cracks);
  return cracks;
}

/** Where an edge passes an edge of a crack, more than a crack's width away from its own ends. */
std::optional<Passage> FindPassage(
  const std::vector<Point>& points, const Edge& edge, const Edge& crack, double width)
{
  const Point u = points[edge[1]] - points[edge[0]], v = points[crack[1]] - points[crack[0]];
  const Point between = points[crack[0]] - points[edge[0]];
  const Point normal = Cross(u, v);
  const double squared = Dot(normal, normal), length = Length(u);
  const double share = Dot(Cross(between, v), normal) / squared;
  if (!(share * length > 2.0 * width && (1.0 - share) * length > 2.0 * width)) // false for NaN
  {
    return std::nullopt;
  }
  const Point p = PointAt(points, edge, share);
  const double distance = Length(PointAt(points, crack, ShareAt(points, crack, p)) - p);
  return distance <= width ? std::optional<Passage>({ share, distance }) : std::nullopt;
}

/** The edges with points from `first` on that may pass through cracks, M's among them. */
Edges FindCandidates(const Tetrahedralization& mesh, int first, const Edges& cracks, double width)
{
  const std::vector<Point>& points = mesh.Surface.Points;
  const Point margin = { width, width, width };
  Box around;
  for (const Edge& crack : cracks)
  {
    for (const int end : crack)
    {
      around.Add(points[end] - margin);
      around.Add(points[end] + margin);
    }
  }
  Edges candidates;
  for (const auto& c : mesh.Cells)
  {
    for (const Edge& edge : EdgesOf(c))
    {
      if (edge[1] >= first &&
        around.Overlaps(BoxAround(std::array{ points[edge[0]], points[edge[1]] })))
      {
        candidates.push_back(edge);
      }
    }
  }
  SortUnique(candidates);
  return candidates;
}

double DistanceFromLine(const std::vector<Point>& points, const Edge& line, const Point& p)
{
  const Point along = points[line[1]] - points[line[0]];
  return Length(Cross(along, p - points[line[0]])) / Length(along);
}

/** Whether both ends of an edge are farther from the line of a crack than the crack is wide. */
bool LeavesCrack(
  const std::vector<Point>& points, const Edge& edge, const Edge& crack, double width)
{
  return std::all_of(edge.begin(), edge.end(),
    [&](int end) { return DistanceFromLine(points, crack, points[end]) > 2.0 * width; });
}

/**
 * Where edges with points from `first` on pass through cracks. An edge does so only if it leaves
 * the crack on both sides: others lie along the crack, and M's among them are its sides.
 */
Passages FindPassages(const Tetrahedralization& mesh, int first, const Edges& cracks, double width)
{
  const std::vector<Point>& points = mesh.Surface.Points;
  const Edges candidates = FindCandidates(mesh, first, cracks, width);
  Passages passages;
  VisitPairs(WidenedBoxes(points, candidates, 0.0), WidenedBoxes(points, cracks, width),
    [&](int i, int k)
    {
      const Edge& edge = candidates[i];
      const std::optional<Passage> passage = FindPassage(points, edge, cracks[k], width);
      if (passage && LeavesCrack(points, edge, cracks[k], width))
      {
        Passage& best = passages.try_emplace(edge, *passage).first->second;
        best = std::min(best, *passage,
          [](const Passage& a, const Passage& b) { return a.Distance < b.Distance; });
      }
    });
  return passages;
}

} // namespace

CrackSplits SplitEdgesThroughCracks(
  const Tetrahedralization& mesh, double width, Tetrahedralization& split)
{
  constexpr int rounds = 4; // an edge may pass through several cracks
  const Edges cracks = FindCracks(mesh.Surface.Points, FindRims(FindEdges(mesh.GetInput())), width);
  if (cracks.empty())
  {
    return {};
  }
  Passages passages = FindPassages(mesh, 0, cracks, width);
  if (passages.empty())
  {
    return {};
  }
  split = mesh;
  CrackSplits result;
  for (int round = 0; round < rounds && !passages.empty(); ++round)
  {
    const int first = static_cast<int>(split.Surface.Points.size());
    Edges passing;
    std::transform(passages.begin(), passages.end(), std::back_inserter(passing),
      [](const auto& entry) { return entry.first; });
    EdgeSplitter splitter(passing, split);
    for (const auto& [edge, passage] : passages)
    {
      result.Points += splitter.Split(edge, passage.Share, 0.25 * width);
    }
    splitter.Finish();
    passages = FindPassages(split, first, cracks, width);
  }
  result.AreEnough = passages.empty();
  return result;
}

bool HasCracksThatStayOpen(const Tetrahedralization& mesh)
{
  Tetrahedralization split;
  const double width = MostCrackWidth * Diagonal(mesh.GetInput());
  return !IsClosed(mesh.GetInput()) && !SplitEdgesThroughCracks(mesh, width, split).AreEnough;
}

} // namespace carving::helper
