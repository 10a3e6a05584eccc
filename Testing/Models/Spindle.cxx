// SPDX-License-Identifier: BSD-3-Clause
#include "Spindle.h"

using carving::Point;

namespace models
{

void AddSpindle(carving::TriangleMesh& mesh, const Point& first,
  const std::vector<std::vector<Point>>& rows, const Point& last, bool closed)
{
  const int start = static_cast<int>(mesh.Points.size());
  const int width = static_cast<int>(rows.front().size());
  mesh.Points.push_back(first);
  for (const std::vector<Point>& row : rows)
  {
    mesh.Points.insert(mesh.Points.end(), row.begin(), row.end());
  }
  const int end = static_cast<int>(mesh.Points.size());
  mesh.Points.push_back(last);
  for (int j = 0; j < (closed ? width : width - 1); ++j)
  {
    const int next = (j + 1) % width;
    mesh.Triangles.push_back({ start, start + 1 + next, start + 1 + j });
    for (int row = start + 1; row + width < end; row += width)
    {
      mesh.Triangles.push_back({ row + j, row + next, row + width + next });
      mesh.Triangles.push_back({ row + j, row + width + next, row + width + j });
    }
    mesh.Triangles.push_back({ end - width + j, end - width + next, end });
  }
}

} // namespace models
