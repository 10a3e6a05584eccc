// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks.h"

#include "Core/Mesh/Vector.h"
#include "Shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace models
{
namespace
{

using namespace carving;
using Node = std::array<int, 3>;

/** A box whose sides are grids of so many cells along each axis. */
TriangleMesh GridBox(const Point& lower, const Point& upper, const Node& cells)
{
  TriangleMesh mesh;
  std::map<Node, int> indices;
  const auto add = [&](const Node& node)
  {
    const auto [found, isNew] = indices.try_emplace(node, static_cast<int>(mesh.Points.size()));
    if (isNew)
    {
      Point p;
      for (int i = 0; i < 3; ++i)
      {
        p[i] = lower[i] + (upper[i] - lower[i]) * node[i] / cells[i];
      }
      mesh.Points.push_back(p);
    }
    return found->second;
  };
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2, u = (axis + 1 + side % 2) % 3, v = 3 - axis - u;
    for (int i = 0; i < cells[u]; ++i)
    {
      for (int j = 0; j < cells[v]; ++j)
      {
        const auto corner = [&](int a, int b)
        {
          Node node;
          node[axis] = side % 2 ? 0 : cells[axis];
          node[u] = a;
          node[v] = b;
          return add(node);
        };
        const int a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1);
        mesh.Triangles.push_back({ a, b, c });
        mesh.Triangles.push_back({ a, c, corner(i, j + 1) });
      }
    }
  }
  return mesh;
}

/** Turned around the z axis, then around the x axis. */
Point Turned(const Point& p)
{
  const double c = std::cos(0.3), s = std::sin(0.3);
  const double y = s * p[0] + c * p[1];
  return { c * p[0] - s * p[1], c * y - s * p[2], s * y + c * p[2] };
}

} // namespace

TriangleMesh Blocks(int density)
{
  TriangleMesh blocks;
  for (int k = 0; k < 26; ++k)
  {
    const double x = 4.0 * (k / 5), y = 4.0 * (k % 5);
    const Point lower = k % 2 ? Point{ x, y, 0.0 } : Point{ x, y + 0.2, 0.0 };
    const Point size = k % 2 ? Point{ 4.0, 0.2, 3.0 } : Point{ 0.2, 4.0, 3.0 };
    const double perLength = density / 4.0 * std::pow(6.0, -(k * 7 % 26) / 25.0);
    Node cells;
    for (int i = 0; i < 3; ++i)
    {
      cells[i] = std::max(1, static_cast<int>(std::lround(perLength * size[i])));
    }
    blocks = Joined(blocks, GridBox(lower, lower + size, cells));
  }
  for (Point& p : blocks.Points)
  {
    p = Turned(p);
  }
  return blocks;
}

} // namespace models
