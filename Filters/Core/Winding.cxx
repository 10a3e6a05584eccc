// SPDX-License-Identifier: BSD-3-Clause
#include "Winding.h"

#include "Vector.h"

#include <algorithm>
#include <utility>

namespace carving
{

double WindingNumber(const ResolvedMesh& mesh, const Point& point)
{
  double halfAngles = 0.0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    if (mesh.Windings[t] == 0)
    {
      continue;
    }
    const Triangle& corner = mesh.Triangles[t];
    const Point a = mesh.Points[corner[0]] - point;
    const Point b = mesh.Points[corner[1]] - point;
    const Point c = mesh.Points[corner[2]] - point;
    const double la = Length(a), lb = Length(b), lc = Length(c);
    // Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983, equation (8).
    const double numerator = Dot(a, Cross(b, c));
    const double denominator = la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb;
    halfAngles += mesh.Windings[t] * std::atan2(numerator, denominator);
  }
  return halfAngles / (2.0 * std::acos(-1.0));
}

bool IsClosed(const ResolvedMesh& mesh)
{
  // Every edge once per triangle, as (smaller vertex, larger vertex) with the signed number of
  // crossings from the smaller to the larger.
  std::vector<std::pair<std::pair<int, int>, int>> edges;
  edges.reserve(3 * mesh.Triangles.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = mesh.Triangles[t][i];
      const int b = mesh.Triangles[t][(i + 1) % 3];
      edges.push_back({ std::minmax(a, b), a < b ? mesh.Windings[t] : -mesh.Windings[t] });
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto first = edges.begin(); first != edges.end();)
  {
    int sum = 0;
    auto last = first;
    for (; last != edges.end() && last->first == first->first; ++last)
    {
      sum += last->second;
    }
    if (sum != 0)
    {
      return false;
    }
    first = last;
  }
  return true;
}

} // namespace carving
