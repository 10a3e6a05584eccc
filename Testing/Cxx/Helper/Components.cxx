// SPDX-License-Identifier: BSD-3-Clause
#include "Components.h"

#include <algorithm>
#include <numeric>

using namespace carving;

std::vector<int> CountComponents(const Tetrahedralization& mesh, const Stream& stream)
{
  std::vector<int> parent(mesh.Surface.Points.size(), -1);
  int components = 0;
  const auto find = [&](int v)
  {
    while (parent[v] != v)
    {
      v = parent[v] = parent[parent[v]];
    }
    return v;
  };
  const auto add = [&](const auto& simplex)
  {
    for (const int v : simplex)
    {
      if (parent[v] < 0)
      {
        parent[v] = v;
        ++components;
      }
      if (find(v) != find(simplex[0]))
      {
        parent[find(v)] = find(simplex[0]);
        --components;
      }
    }
  };
  for (const Triangle& t : mesh.Surface.Facets)
  {
    add(t);
  }
  std::vector<int> order(mesh.Cells.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(
    order.begin(), order.end(), [&](int a, int b) { return stream.Step[a] > stream.Step[b]; });
  std::vector<int> result(stream.LastStep() + 1);
  std::size_t next = 0;
  for (int step = stream.LastStep(); step >= 0; --step)
  {
    for (; next < order.size() && stream.Step[order[next]] > step; ++next)
    {
      add(mesh.Cells[order[next]]);
    }
    result[step] = components;
  }
  return result;
}
