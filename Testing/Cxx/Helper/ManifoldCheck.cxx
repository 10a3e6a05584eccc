// SPDX-License-Identifier: BSD-3-Clause
#include "ManifoldCheck.h"

#include <algorithm>
#include <map>
#include <set>

using namespace carving;

namespace
{

/**
 * Whether the triangles around a vertex are one fan: whether the edges opposite to the vertex are
 * connected.
 */
bool IsOneFan(const std::vector<std::pair<int, int>>& link)
{
  std::map<int, std::vector<int>> adjacent;
  for (const auto& [a, b] : link)
  {
    adjacent[a].push_back(b);
    adjacent[b].push_back(a);
  }
  std::set<int> reached;
  std::vector<int> stack = { link[0].first };
  while (!stack.empty())
  {
    const int vertex = stack.back();
    stack.pop_back();
    if (reached.insert(vertex).second)
    {
      stack.insert(stack.end(), adjacent[vertex].begin(), adjacent[vertex].end());
    }
  }
  return reached.size() == adjacent.size();
}

} // namespace

checks::ManifoldFaults checks::FindFaults(const Level<3>& level, const ManifoldLevel<3>& cut)
{
  ManifoldFaults faults;
  struct Uses
  {
    int Forward = 0;
    int Backward = 0;
    bool Solid = false;
  };
  std::map<std::pair<int, int>, Uses> edges;
  std::map<int, std::vector<std::pair<int, int>>> links;
  for (std::size_t i = 0; i < cut.Faces.size(); ++i)
  {
    const Triangle& t = cut.Faces[i];
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[k], b = t[(k + 1) % 3];
      Uses& uses = edges[std::minmax(a, b)];
      ++(a < b ? uses.Forward : uses.Backward);
      uses.Solid = uses.Solid || !level.Faces[i].Fold;
      links[t[k]].push_back({ b, t[(k + 2) % 3] });
      faults.MovedCorners += cut.Points[t[k]] != level.Faces[i].Corners[k];
    }
  }
  for (const auto& [edge, uses] : edges)
  {
    const int count = uses.Forward + uses.Backward;
    faults.CrowdedEdges += count > 2;
    faults.MisorientedEdges += uses.Forward > 1 || uses.Backward > 1;
    faults.OpenSolidEdges += uses.Solid && count == 1;
  }
  for (const auto& [vertex, link] : links)
  {
    faults.SeveralFans += !IsOneFan(link);
  }
  return faults;
}

int checks::Genus(const ManifoldLevel<3>& cut)
{
  std::map<int, std::vector<int>> facesAround;
  for (std::size_t i = 0; i < cut.Faces.size(); ++i)
  {
    for (const int vertex : cut.Faces[i])
    {
      facesAround[vertex].push_back(static_cast<int>(i));
    }
  }
  int genus = 0;
  std::set<int> seen;
  for (const auto& start : facesAround)
  {
    std::vector<int> stack = { start.first };
    std::set<int> faces;
    std::map<std::pair<int, int>, int> edges;
    int vertices = 0;
    while (!stack.empty())
    {
      const int vertex = stack.back();
      stack.pop_back();
      if (!seen.insert(vertex).second)
      {
        continue;
      }
      ++vertices;
      for (const int face : facesAround[vertex])
      {
        if (faces.insert(face).second)
        {
          const auto& [a, b, c] = cut.Faces[face];
          stack.insert(stack.end(), { a, b, c });
          ++edges[std::minmax(a, b)];
          ++edges[std::minmax(b, c)];
          ++edges[std::minmax(c, a)];
        }
      }
    }
    const bool closed =
      std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 2; });
    if (vertices > 0 && closed)
    {
      genus += (2 - vertices + static_cast<int>(edges.size()) - static_cast<int>(faces.size())) / 2;
    }
  }
  return genus;
}
