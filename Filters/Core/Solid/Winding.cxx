// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Winding.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <utility>

namespace carving
{

double SolidAngle(const ResolvedMesh& mesh, std::size_t triangle, const Point& point)
{
  const Triangle& corner = mesh.Facets[triangle];
  const Point a = mesh.Points[corner[0]] - point;
  const Point b = mesh.Points[corner[1]] - point;
  const Point c = mesh.Points[corner[2]] - point;
  const double la = Length(a), lb = Length(b), lc = Length(c);
  // Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983, equation (8).
  const double numerator = Dot(a, Cross(b, c));
  const double denominator = la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb;
  return 2.0 * std::atan2(numerator, denominator);
}

double WindingNumber(const ResolvedMesh& mesh, const Point& point)
{
  double angles = 0.0;
  for (std::size_t t = 0; t < mesh.Facets.size(); ++t)
  {
    if (mesh.SignedMultiplicities[t] != 0)
    {
      angles += mesh.SignedMultiplicities[t] * SolidAngle(mesh, t, point);
    }
  }
  return angles / (4.0 * std::acos(-1.0));
}

double WindingNumber(const ResolvedInput<2>& contours, const Point& point)
{
  double angles = 0.0;
  for (std::size_t e = 0; e < contours.Facets.size(); ++e)
  {
    const auto& [from, to] = contours.Facets[e];
    const Point a = contours.Points[from] - point;
    const Point b = contours.Points[to] - point;
    angles += contours.SignedMultiplicities[e] *
      std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  }
  return angles / (2.0 * std::acos(-1.0));
}

int CountCrossings(const ResolvedMesh& mesh, const Point& point)
{
  const Point direction = { 0.5377, 0.2913, 0.7912 };
  int count = 0;
  for (std::size_t t = 0; t < mesh.Facets.size(); ++t)
  {
    const Triangle& corner = mesh.Facets[t];
    const Point a = mesh.Points[corner[0]] - point;
    const Point b = mesh.Points[corner[1]] - point;
    const Point c = mesh.Points[corner[2]] - point;
    // The ray crosses the triangle if all edges pass it on the same side and the triangle lies
    // ahead.
    const double ab = Dot(direction, Cross(a, b)), bc = Dot(direction, Cross(b, c)),
                 ca = Dot(direction, Cross(c, a));
    const bool within = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
    if (within && (Dot(a, Cross(b, c)) > 0) == (ab > 0))
    {
      count += mesh.Multiplicities[t];
    }
  }
  return count;
}

bool IsClosed(const ResolvedInput<2>& contours)
{
  std::vector<int> sums(
    contours.Points.size(), 0); // edges that end at a point, less those that begin
  for (std::size_t e = 0; e < contours.Facets.size(); ++e)
  {
    const auto& [from, to] = contours.Facets[e];
    sums[from] -= contours.SignedMultiplicities[e];
    sums[to] += contours.SignedMultiplicities[e];
  }
  return std::all_of(sums.begin(), sums.end(), [](int sum) { return sum == 0; });
}

bool IsClosed(const ResolvedInput<3>& mesh)
{
  // Each edge of each triangle, by its lesser vertex: the greater one and how often the edge is
  // traversed towards it, less the traversals back.
  using Edge = std::pair<int, int>;
  Buckets<Edge> edges(mesh.Points.size(),
    [&mesh](auto&& visit)
    {
      for (std::size_t t = 0; t < mesh.Facets.size(); ++t)
      {
        for (int i = 0; i < 3; ++i)
        {
          const int a = mesh.Facets[t][i], b = mesh.Facets[t][(i + 1) % 3];
          const int count = mesh.SignedMultiplicities[t];
          visit(std::min(a, b), Edge(std::max(a, b), a < b ? count : -count));
        }
      }
    });
  std::vector<int> sums(mesh.Points.size(), 0); // per greater vertex
  for (int vertex = 0; vertex < edges.GetNumberOfBuckets(); ++vertex)
  {
    for (const auto& [other, count] : edges[vertex])
    {
      sums[other] += count;
    }
    for (const Edge& edge : edges[vertex])
    {
      if (sums[edge.first] != 0)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace carving
