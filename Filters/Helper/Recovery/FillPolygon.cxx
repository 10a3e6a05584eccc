// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/FillPolygon.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>

namespace carving::helper
{
namespace
{

using Vertex = PiercedMesh::Vertex;

/** Twice the area of a triangle, seen against a normal, as a share of its longest squared edge. */
double ShapeOf(const VertexTriangle& t, const Point& normal)
{
  const Point a = ToPoint(t[0]->point()), b = ToPoint(t[1]->point()), c = ToPoint(t[2]->point());
  const double longest = std::max({ Dot(b - a, b - a), Dot(c - b, c - b), Dot(a - c, a - c) });
  return Dot(Cross(b - a, c - a), normal) / longest;
}

/** Whether a point is inside of a triangle or on its border, when seen along a normal. */
bool Covers(const VertexTriangle& t, const Point& p, const Point& normal)
{
  for (int i = 0; i < 3; ++i)
  {
    const Point a = ToPoint(t[i]->point()), b = ToPoint(t[(i + 1) % 3]->point());
    if (Dot(Cross(b - a, p - a), normal) < 0.0)
    {
      return false;
    }
  }
  return true;
}

} // namespace

std::vector<VertexTriangle> FillPolygon(std::vector<Vertex> polygon, const Point& normal)
{
  constexpr double flat = 1e-9;
  std::vector<VertexTriangle> triangles;
  while (polygon.size() > 2)
  {
    const std::size_t count = polygon.size();
    std::size_t best = count;
    double bestShape = flat;
    for (std::size_t i = 0; i < count; ++i)
    {
      const VertexTriangle ear = { polygon[(i + count - 1) % count], polygon[i],
        polygon[(i + 1) % count] };
      const double shape = ShapeOf(ear, normal);
      const auto isInWay = [&](const Vertex& v)
      {
        return std::find(ear.begin(), ear.end(), v) == ear.end() &&
          Covers(ear, ToPoint(v->point()), normal);
      };
      if (shape > bestShape && std::none_of(polygon.begin(), polygon.end(), isInWay))
      {
        best = i;
        bestShape = shape;
      }
    }
    if (best == count)
    {
      return {};
    }
    triangles.push_back(
      { polygon[(best + count - 1) % count], polygon[best], polygon[(best + 1) % count] });
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return triangles;
}

} // namespace carving::helper
