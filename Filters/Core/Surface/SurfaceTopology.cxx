// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/SurfaceTopology.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/DisjointSets.h"

#include <algorithm>

namespace carving
{
namespace
{

/**
 * Per vertex, the greater ends of its edges that are traversed upward, or else downward; ascending.
 */
Buckets<int> SortEdges(const ManifoldLevel<3>& level, bool upward)
{
  Buckets<int> edges(level.Points.size(),
    [&](auto&& visit)
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
    });
  for (int vertex = 0; vertex < edges.GetNumberOfBuckets(); ++vertex)
  {
    std::sort(edges[vertex].begin(), edges[vertex].end());
  }
  return edges;
}

/** Whether every edge has two faces, which traverse it in opposite directions. */
bool IsClosed(const ManifoldLevel<3>& level)
{
  return SortEdges(level, true) == SortEdges(level, false);
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
  // A closed surface has three edges for every two faces.
  const int characteristic =
    static_cast<int>(level.Points.size()) - static_cast<int>(level.Faces.size()) / 2;
  topology.Genus = IsClosed(level) ? topology.Components - characteristic / 2 : -1;
  return topology;
}

template int CountSurfaceComponents<2>(const ManifoldLevel<2>&);
template int CountSurfaceComponents<3>(const ManifoldLevel<3>&);

} // namespace carving
