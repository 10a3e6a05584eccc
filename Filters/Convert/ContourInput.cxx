// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/ContourInput.h"

#include "Convert/InputCells.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/SortUnique.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace carving;

namespace
{

/** The distance from the plane that a point may have, as a share of the diagonal. */
constexpr double PlaneTolerance = 1e-6;

/** The points that edges use, ascending. */
std::vector<int> UsedPoints(const ContourSet& contours)
{
  std::vector<int> used;
  used.reserve(2 * contours.Edges.size());
  for (const auto& edge : contours.Edges)
  {
    used.insert(used.end(), edge.begin(), edge.end());
  }
  carving::SortUnique(used);
  return used;
}

/** The unit normal of the plane through three points far from each other. */
Point FindNormal(const std::vector<Point>& points)
{
  const Point along = FarthestFromFirst(points, [](const Point& v) { return Length(v); });
  const Point across =
    FarthestFromFirst(points, [&](const Point& v) { return Length(Cross(along, v)); });
  Point normal = Cross(along, across);
  if (Length(normal) ==
    0.0) // on a line: take the plane through it whose normal is closest to an axis
  {
    Point axis = { 0.0, 0.0, 0.0 };
    const auto least = std::min_element(
      along.rbegin(), along.rend(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    axis[along.rend() - least - 1] = 1.0;
    normal = Length(along) > 0.0 ? Cross(along, Cross(axis, along)) : axis;
  }
  return normal / Length(normal);
}

std::size_t CountSkipped(vtkPolyData* input)
{
  return static_cast<std::size_t>(input->GetNumberOfVerts() + input->GetNumberOfStrips());
}

} // namespace

std::string ContourInput::Gather(vtkPolyData* input)
{
  *this = {};
  return this->GatherEdges(input);
}

std::string ContourInput::GatherInPlaneOf(const ContourInput& other, vtkPolyData* input)
{
  *this = {};
  this->Common = other.Common;
  return this->GatherEdges(input);
}

std::string ContourInput::GatherEdges(vtkPolyData* input)
{
  const std::string error = CheckCells(input, { input->GetLines(), input->GetPolys() });
  if (!error.empty())
  {
    return error;
  }
  if (CountSkipped(input) > 0)
  {
    this->Notes.push_back("Vertices and triangle strips are no contours: " +
      std::to_string(CountSkipped(input)) + " cells were ignored.");
  }
  for (vtkCellArray* cells : { input->GetLines(), input->GetPolys() })
  {
    const bool closed = cells == input->GetPolys();
    VisitCells(input, { cells },
      [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
      {
        for (vtkIdType k = closed ? 0 : 1; k < size; ++k)
        {
          const vtkIdType from = corners[k > 0 ? k - 1 : size - 1];
          this->Contours.Edges.push_back({ static_cast<int>(from), static_cast<int>(corners[k]) });
          this->CellIds.push_back(cell);
        }
      });
  }
  this->Contours.Points.resize(input->GetNumberOfPoints());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoint(i, this->Contours.Points[i].data());
  }
  const std::string outOfPlane = this->IsEmpty() ? "" : this->CheckPlane();
  if (outOfPlane.empty())
  {
    this->PermuteAxes();
  }
  return outOfPlane;
}

std::string ContourInput::CheckPlane()
{
  const std::vector<Point>& points = this->Contours.Points;
  const std::vector<int> used = UsedPoints(this->Contours);
  Plane& plane = this->Common;
  const bool given = plane.Known;
  if (!given)
  {
    std::vector<Point> all;
    for (const int i : used)
    {
      all.push_back(points[i]);
    }
    const auto [lower, upper] = BoxAround(all);
    plane = { true, all.front(), FindNormal(all), PlaneTolerance * Length(upper - lower) };
  }
  for (const int i : used)
  {
    const double distance = std::abs(Dot(points[i] - plane.Origin, plane.Normal));
    if (distance > plane.Tolerance)
    {
      std::ostringstream message;
      message << "Point " << i << " is " << distance << " away from the plane of the "
              << (given ? "input" : "others")
              << ": contours must lie in one plane, to within one millionth of their diagonal.";
      return message.str();
    }
  }
  return {};
}

void ContourInput::PermuteAxes()
{
  this->Axis = 2;
  for (const int axis : { 1, 0 })
  {
    if (std::abs(this->Common.Normal[axis]) > std::abs(this->Common.Normal[this->Axis]))
    {
      this->Axis = axis;
    }
  }
  // A cyclic permutation keeps the orientation.
  for (Point& p : this->Contours.Points)
  {
    p = { p[(this->Axis + 1) % 3], p[(this->Axis + 2) % 3], p[this->Axis] };
  }
}

void ContourInput::Restore(std::vector<Point>& points) const
{
  for (Point& p : points)
  {
    const Point rotated = p;
    for (int i = 0; i < 3; ++i)
    {
      p[(this->Axis + 1 + i) % 3] = rotated[i];
    }
  }
}
