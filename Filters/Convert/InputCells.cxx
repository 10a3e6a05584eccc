// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/InputCells.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/LargePages.h"
#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{

/**
 * Bounds that keep all computed terms finite: the terms are of degree eight at most in the
 * coordinates.
 */
constexpr double LargestCoordinate = 1e38;
constexpr double SmallestDiagonal = 1e-38;

/** Marks the points that cells use. Returns an empty string, or an error. */
std::string FindUsed(
  vtkPolyData* input, std::initializer_list<vtkCellArray*> cells, std::vector<char>& used)
{
  std::ostringstream error;
  const vtkIdType count = input->GetNumberOfPoints();
  used.assign(count, 0);
  VisitCells(input, cells,
    [&](vtkIdType id, vtkIdType size, const vtkIdType* corners)
    {
      for (vtkIdType k = 0; k < size; ++k)
      {
        if (corners[k] >= 0 && corners[k] < count)
        {
          used[corners[k]] = 1;
        }
        else if (error.tellp() == 0)
        {
          error << "Cell " << id << " has the point " << corners[k] << ", but there are only "
                << count << " points. Remove the cell.";
        }
      }
    });
  return error.str();
}

std::string DescribePoint(vtkIdType id, const carving::Point& p)
{
  std::ostringstream text;
  text << "Point " << id << " is (" << p[0] << ", " << p[1] << ", " << p[2] << "): ";
  return text.str();
}

std::string CheckPoint(vtkIdType id, const carving::Point& p)
{
  if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
  {
    return DescribePoint(id, p) + "coordinates must be finite. Remove the cells that use it.";
  }
  if (std::any_of(p.begin(), p.end(), [](double x) { return std::abs(x) > LargestCoordinate; }))
  {
    return DescribePoint(id, p) +
      "coordinates must not be beyond 1e38. Remove the cells that use it, or scale the input.";
  }
  return {};
}

std::string CheckDiagonal(const std::vector<carving::Point>& points)
{
  const auto [lower, upper] = carving::BoxAround(points);
  const double diagonal = std::hypot(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]);
  return diagonal > 0.0 && diagonal < SmallestDiagonal
    ? "The input's diagonal is shorter than 1e-38. Scale the input."
    : "";
}

} // namespace

std::string CheckCells(vtkPolyData* input, std::initializer_list<vtkCellArray*> cells)
{
  if (input->GetNumberOfPoints() > VTK_INT_MAX || input->GetNumberOfCells() > VTK_INT_MAX)
  {
    return "The input has more points or cells than a 32-bit integer can count.";
  }
  if (!std::all_of(
        cells.begin(), cells.end(), [](vtkCellArray* array) { return array->IsValid(); }))
  {
    return "The offsets of the input's cells do not fit their corners. Make the input anew, or "
           "read it from a file that is whole.";
  }
  std::vector<char> used;
  const std::string mistake = FindUsed(input, cells, used);
  if (!mistake.empty())
  {
    return mistake;
  }
  std::vector<carving::Point> points;
  carving::ReserveLarge(points, std::count(used.begin(), used.end(), 1));
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(used.size()); ++i)
  {
    if (used[i])
    {
      carving::Point p;
      input->GetPoint(i, p.data());
      const std::string invalid = CheckPoint(i, p);
      if (!invalid.empty())
      {
        return invalid;
      }
      points.push_back(p);
    }
  }
  return points.empty() ? "" : CheckDiagonal(points);
}
