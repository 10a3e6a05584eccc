// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Winding.h"

#include "Core/Mesh/Buckets.h"
#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>

namespace carving
{
namespace
{

/** A side of a facet: an edge of a triangle, or an end of an edge of contours. */
struct Side
{
  int Other; ///< the greater point of a triangle's edge; 0 for an end
  /** Traversals towards `Other`, less those back; at an end, 1 per traversal to it, -1 from it. */
  int Count;
  int Facet;
};

/** The sides of all contours by their points. */
Buckets<Side> CollectSides(const ResolvedInput<2>& contours)
{
  return Buckets<Side>(contours.Points.size(),
    [&contours](auto&& visit)
    {
      for (int e = 0; e < static_cast<int>(contours.Facets.size()); ++e)
      {
        if (const int count = contours.SignedMultiplicities[e])
        {
          visit(contours.Facets[e][0], Side{ 0, -count, e });
          visit(contours.Facets[e][1], Side{ 0, count, e });
        }
      }
    });
}

/** The sides of all triangles by their lesser points. */
Buckets<Side> CollectSides(const ResolvedMesh& mesh)
{
  return Buckets<Side>(mesh.Points.size(),
    [&mesh](auto&& visit)
    {
      for (int t = 0; t < static_cast<int>(mesh.Facets.size()); ++t)
      {
        const int count = mesh.SignedMultiplicities[t];
        for (int i = 0; i < 3 && count != 0; ++i)
        {
          const int a = mesh.Facets[t][i], b = mesh.Facets[t][(i + 1) % 3];
          visit(std::min(a, b), Side{ std::max(a, b), a < b ? count : -count, t });
        }
      }
    });
}

} // namespace

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

template <int D>
std::vector<char> FindClosedParts(const ResolvedInput<D>& mesh)
{
  Buckets<Side> sides = CollectSides(mesh);
  DisjointSets parts(mesh.Facets.size());
  std::vector<int> open; // facets with an open side
  for (int point = 0; point < sides.GetNumberOfBuckets(); ++point)
  {
    const auto [first, last] = sides[point];
    std::sort(first, last, [](const Side& a, const Side& b) { return a.Other < b.Other; });
    for (auto begin = first, end = first; begin != last; begin = end)
    {
      int sum = 0;
      for (; end != last && end->Other == begin->Other; ++end)
      {
        sum += end->Count;
        parts.Unite(begin->Facet, end->Facet);
      }
      if (sum != 0)
      {
        open.push_back(begin->Facet);
      }
    }
  }
  std::vector<char> isOpen(mesh.Facets.size(), 0); // per first facet of a part
  for (const int facet : open)
  {
    isOpen[parts.Find(facet)] = 1;
  }
  std::vector<char> isClosed(mesh.Facets.size());
  for (std::size_t facet = 0; facet < mesh.Facets.size(); ++facet)
  {
    isClosed[facet] = !isOpen[parts.Find(static_cast<int>(facet))];
  }
  return isClosed;
}

bool IsClosed(const ResolvedMesh& mesh)
{
  const std::vector<char> isClosed = FindClosedParts(mesh);
  return std::find(isClosed.begin(), isClosed.end(), 0) == isClosed.end();
}

template std::vector<char> FindClosedParts<2>(const ResolvedInput<2>&);
template std::vector<char> FindClosedParts<3>(const ResolvedInput<3>&);

} // namespace carving
