// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Plane/Triangulate.h"

#include "Core/Mesh/Adjacency.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Base/GrownBox.h"
#include "Helper/Base/PlaneTriangulation.h"
#include "Helper/Plane/InitialContour.h"

#include <algorithm>
#include <cmath>

namespace carving::helper
{
namespace
{

Point Flat(const Point& p)
{
  return { p[0], p[1], 0.0 };
}

/**
 * The third coordinate as a linear function of the others, through three points far from each
 * other.
 */
class Height
{
public:
  explicit Height(const std::vector<Point>& points)
    : Origin(points.front())
  {
    const Point along =
      FarthestFromFirst(points, [](const Point& d) { return Dot(Flat(d), Flat(d)); });
    const Point across =
      FarthestFromFirst(points, [&](const Point& d) { return std::abs(Cross(along, d)[2]); });
    const double area = Cross(along, across)[2];
    const double squared = along[0] * along[0] + along[1] * along[1];
    if (area != 0.0)
    {
      this->Slope = { (along[2] * across[1] - across[2] * along[1]) / area,
        (across[2] * along[0] - along[2] * across[0]) / area };
    }
    else if (squared > 0.0) // all points are on a line: level across it
    {
      this->Slope = { along[2] * along[0] / squared, along[2] * along[1] / squared };
    }
  }

  double At(double x, double y) const
  {
    return this->Origin[2] + this->Slope[0] * (x - this->Origin[0]) +
      this->Slope[1] * (y - this->Origin[1]);
  }

private:
  Point Origin;
  std::array<double, 2> Slope = { 0.0, 0.0 };
};

/** The corners of the rectangle around the points, grown by BoxMargin of its diagonal. */
std::vector<Point> GrownRectangle(const std::vector<Point>& points)
{
  const auto [lower, upper] = BoxAround(points);
  const double margin = BoxMargin * Length(Flat(upper - lower));
  const Height height(points);
  std::vector<Point> corners;
  for (const double x : { lower[0] - margin, upper[0] + margin })
  {
    for (const double y : { lower[1] - margin, upper[1] + margin })
    {
      corners.push_back({ x, y, height.At(x, y) });
    }
  }
  return corners;
}

/** Puts the points of M before all others, and the edges of M before those of C0 alone. */
Decomposition<2> SortPoints(const Contours& contours, std::vector<char>& initial)
{
  Decomposition<2> result;
  std::vector<int> newIndex(contours.Points.size(), -1);
  std::vector<char> ofInput(contours.Points.size(), 0);
  for (std::size_t i = 0; i < contours.Facets.size(); ++i)
  {
    for (const int end : contours.Facets[i])
    {
      ofInput[end] = ofInput[end] || contours.Multiplicities[i] > 0;
    }
  }
  ResolvedInput<2>& to = result.Surface;
  for (const bool first : { true, false })
  {
    for (std::size_t i = 0; i < contours.Points.size(); ++i)
    {
      if (first == static_cast<bool>(ofInput[i]))
      {
        newIndex[i] = static_cast<int>(to.Points.size());
        to.Points.push_back(contours.Points[i]);
        to.PointSources.push_back(contours.PointSources[i]);
      }
    }
    for (std::size_t i = 0; i < contours.Facets.size(); ++i)
    {
      if (first == (contours.Multiplicities[i] > 0))
      {
        AppendFacet<2>(contours, i, contours.Facets[i], to);
        initial.push_back(contours.Initial[i]);
      }
    }
  }
  for (auto& [from, end] : to.Facets)
  {
    from = newIndex[from];
    end = newIndex[end];
  }
  return result;
}

/** Fills `mesh.Cells` and their adjacency. Returns false if all points lie on one line. */
bool MakeCells(Decomposition<2>& mesh)
{
  PlaneTriangulation triangulation;
  const auto vertices = InsertPoints(mesh.Surface.Points, triangulation);
  for (const auto& [from, to] : mesh.Surface.Facets)
  {
    triangulation.insert_constraint(vertices[from], vertices[to]);
  }
  if (triangulation.dimension() < 2)
  {
    return false;
  }
  for (const auto face : triangulation.finite_face_handles())
  {
    std::array<int, 3>& cell = mesh.Cells.emplace_back();
    for (int i = 0; i < 3; ++i)
    {
      cell[i] = face->vertex(i)->info().Value;
    }
  }
  return FindAdjacency(mesh);
}

} // namespace

std::string Triangulate(const Contours& contours, InitialApproximation initial,
  const ContourSet& given, Decomposition<2>& result)
{
  if (std::all_of(contours.Multiplicities.begin(), contours.Multiplicities.end(),
        [](int n) { return n == 0; }))
  {
    return "No edge of the contours has a length: there is nothing to carve.";
  }
  std::vector<char> ofInitial;
  result = SortPoints(contours, ofInitial);
  if (initial == InitialApproximation::BoundingBox)
  {
    for (const Point& corner : GrownRectangle(result.Surface.Points))
    {
      result.Surface.Points.push_back(corner);
      result.Surface.PointSources.push_back(-1);
    }
  }
  if (!MakeCells(result))
  {
    return "All points lie on one line, so that their convex hull has no area to carve.";
  }
  return initial == InitialApproximation::Custom ? RemoveOutsideOfInitial(given, ofInitial, result)
                                                 : std::string();
}

} // namespace carving::helper
