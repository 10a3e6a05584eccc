// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Recovery/SpaceFilling.h"

#include "Core/Mesh/SortUnique.h"
#include "Helper/Enclosing/CellShape.h"
#include "Helper/Recovery/CavityPoints.h"

#include <algorithm>
#include <cmath>

namespace carving::helper
{
namespace
{

using Cell = PiercedMesh::Cell;
using Vertex = PiercedMesh::Vertex;

Corners3 CornersOf(const VertexTriangle& t)
{
  return { t[0]->point(), t[1]->point(), t[2]->point() };
}

void SortByIndex(std::vector<Vertex>& vertices)
{
  SortUnique(
    vertices, [](const Vertex& a, const Vertex& b) { return a->info().Index < b->info().Index; });
}

/**
 * The least quality of the tetrahedra between an apex, which can be a vertex of the border, and the
 * triangles of the border; 0 if one of them is not oriented positively. Ends at the first quality
 * that is not above `floor`, and returns it.
 */
double FindQuality(
  const Border& border, const Inexact::Point_3& apex, const Vertex& v, double floor)
{
  double least = HUGE_VAL;
  for (const VertexTriangle& t : border)
  {
    if (Has(t, v))
    {
      continue;
    }
    const Corners4 corners = { t[0]->point(), t[1]->point(), t[2]->point(), apex };
    if (CGAL::orientation(corners[0], corners[1], corners[2], corners[3]) != CGAL::POSITIVE)
    {
      return 0.0;
    }
    least = std::min(least, QualityOf(corners));
    if (least <= floor)
    {
      return least;
    }
  }
  return least;
}

} // namespace

SpaceFilling MakeStar(const Border& border, const Vertex& apex, const Inexact::Point_3& p)
{
  SpaceFilling star{ { apex }, { p }, {} };
  for (const VertexTriangle& t : border)
  {
    if (!Has(t, apex))
    {
      const int first = static_cast<int>(star.Vertices.size());
      star.Vertices.insert(star.Vertices.end(), t.begin(), t.end());
      star.Points.resize(star.Vertices.size());
      star.Cells.push_back({ first, first + 1, first + 2, 0 });
    }
  }
  return star;
}

std::optional<SpaceFilling> FillFromVertex(const Border& border)
{
  std::vector<Vertex> vertices;
  for (const VertexTriangle& t : border)
  {
    vertices.insert(vertices.end(), t.begin(), t.end());
  }
  SortByIndex(vertices);
  Vertex apex;
  double best = 0.0;
  for (const Vertex& v : vertices)
  {
    const double quality = FindQuality(border, v->point(), v, best);
    apex = quality > best ? v : apex;
    best = std::max(best, quality);
  }
  if (apex == Vertex())
  {
    return {};
  }
  return MakeStar(border, apex, apex->point());
}

std::optional<SpaceFilling> FillFromPoint(const Border& border, const Inexact::Point_3& from)
{
  Inexact::Point_3 apex;
  double best = 0.0;
  for (const VertexTriangle& t : border)
  {
    const Inexact::Vector_3 way =
      CGAL::centroid(t[0]->point(), t[1]->point(), t[2]->point()) - from;
    constexpr int closest = 30;
    double quality = 0.0;
    for (int i = 1; i < closest && quality == 0.0; ++i)
    {
      const Inexact::Point_3 p = from + std::ldexp(1.0, -i) * way;
      quality = FindQuality(border, p, Vertex(), best);
      apex = quality > best ? p : apex;
      best = std::max(best, quality);
    }
  }
  if (best == 0.0)
  {
    return {};
  }
  return MakeStar(border, Vertex(), apex);
}

std::optional<SpaceFilling> SearchFilling(const std::vector<Cell>& cells, const Border& border,
  const Vertex& v, int points, std::mt19937& random)
{
  SpaceFilling filling;
  std::vector<Corners4> corners;
  for (const Cell& cell : cells)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (cell->vertex(i) != v)
      {
        filling.Vertices.push_back(cell->vertex(i));
      }
    }
    corners.push_back(helper::CornersOf(cell));
  }
  SortByIndex(filling.Vertices);
  if (filling.Vertices.size() > MaximumCavityVertices)
  {
    return {};
  }
  Cavity cavity;
  for (const Vertex& vertex : filling.Vertices)
  {
    cavity.AddPoint(vertex->point(), true, false);
  }
  for (const VertexTriangle& t : border)
  {
    Triangle face;
    for (int i = 0; i < 3; ++i)
    {
      face[i] = static_cast<int>(std::find(filling.Vertices.begin(), filling.Vertices.end(), t[i]) -
        filling.Vertices.begin());
    }
    cavity.Front.push_back(face);
  }
  AddCavityPoints(corners, CornersOf(border.front()), points, random, cavity);
  Filling search(cavity);
  std::ptrdiff_t steps = 100000;
  if (!search.Run(steps))
  {
    return {};
  }
  filling.Vertices.resize(cavity.Points.size());
  filling.Points = cavity.Points;
  filling.Cells = search.GetCells();
  return filling;
}

} // namespace carving::helper
