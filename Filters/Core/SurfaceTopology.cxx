// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTopology.h"

#include "DisjointSets.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace carving
{
namespace
{

/** Whether every edge has two faces, along which it runs in opposite directions. */
bool IsClosed(const std::vector<Triangle>& faces)
{
  std::vector<std::pair<int, int>> up, down; // edges by the direction, lower vertex first
  for (const Triangle& face : faces)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int from = face[i], to = face[(i + 1) % 3];
      from < to ? up.emplace_back(from, to) : down.emplace_back(to, from);
    }
  }
  if (up.size() != down.size())
  {
    return false;
  }
  std::sort(up.begin(), up.end());
  std::sort(down.begin(), down.end());
  return up == down;
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
  topology.Genus = IsClosed(level.Faces) ? topology.Components - characteristic / 2 : -1;
  return topology;
}

template int CountSurfaceComponents<2>(const ManifoldLevel<2>&);
template int CountSurfaceComponents<3>(const ManifoldLevel<3>&);

} // namespace carving
