// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/SurfaceTopology.h"

#include "Core/Mesh/DisjointSets.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace carving
{
namespace
{

/** Edges in one direction, by their lower vertex: of vertex v `Ends[v]` to before `Ends[v + 1]`. */
struct DirectedEdges
{
  std::vector<int> Ends;
  std::vector<int> Upper; ///< ascending for each lower vertex
};

/** The edges that run up to the greater vertex, or those that run down. */
DirectedEdges SortEdges(const ManifoldLevel<3>& level, bool upward)
{
  const auto forEachEdge = [&](auto&& visit)
  {
    for (const Triangle& face : level.Faces)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int from = face[i], to = face[(i + 1) % 3];
        if ((from < to) == upward)
        {
          visit(std::min(from, to), std::max(from, to));
        }
      }
    }
  };
  DirectedEdges edges;
  // Counted one entry too far, places become ends when all have been taken.
  edges.Ends.assign(level.Points.size() + 2, 0);
  forEachEdge([&](int lower, int) { ++edges.Ends[lower + 2]; });
  std::partial_sum(edges.Ends.begin(), edges.Ends.end(), edges.Ends.begin());
  edges.Upper.resize(edges.Ends.back());
  forEachEdge([&](int lower, int upper) { edges.Upper[edges.Ends[lower + 1]++] = upper; });
  edges.Ends.pop_back();
  for (std::size_t vertex = 0; vertex + 1 < edges.Ends.size(); ++vertex)
  {
    std::sort(
      edges.Upper.begin() + edges.Ends[vertex], edges.Upper.begin() + edges.Ends[vertex + 1]);
  }
  return edges;
}

/** Whether every edge has two faces, along which it runs in opposite directions. */
bool IsClosed(const ManifoldLevel<3>& level)
{
  const DirectedEdges up = SortEdges(level, true), down = SortEdges(level, false);
  return up.Ends == down.Ends && up.Upper == down.Upper;
}

} // namespace

template <int D>
int CountSurfaceComponents(const ManifoldLevel<D>& level)
{
  DisjointSets sets(level.Points.size());
  for (const auto& face : level.Faces)
  {
    for (const int vertex : face)
    {
      sets.Unite(face[0], vertex);
    }
  }
  int count = 0;
  for (int vertex = 0; vertex < static_cast<int>(level.Points.size()); ++vertex)
  {
    count += sets.Find(vertex) == vertex;
  }
  return count;
}

SurfaceTopology MeasureSurface(const ManifoldLevel<3>& level)
{
  SurfaceTopology topology;
  topology.Components = CountSurfaceComponents(level);
  // Closed, it has three edges to two faces.
  const int characteristic =
    static_cast<int>(level.Points.size()) - static_cast<int>(level.Faces.size()) / 2;
  topology.Genus = IsClosed(level) ? topology.Components - characteristic / 2 : -1;
  return topology;
}

template int CountSurfaceComponents<2>(const ManifoldLevel<2>&);
template int CountSurfaceComponents<3>(const ManifoldLevel<3>&);

} // namespace carving
