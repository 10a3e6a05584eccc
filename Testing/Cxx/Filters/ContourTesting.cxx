// SPDX-License-Identifier: BSD-3-Clause
#include "ContourTesting.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace
{

vtkSmartPointer<vtkPolyData> MakeContours(const std::vector<Loop>& loops, bool closed)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Loop& loop : loops)
  {
    cells->InsertNextCell(static_cast<int>(loop.size()));
    for (const carving::Point& p : loop)
    {
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  if (closed)
  {
    result->SetPolys(cells);
  }
  else
  {
    result->SetLines(cells);
  }
  return result;
}

/** Calls a function with the ends of every edge. */
template <class Function>
void ForEachEdge(vtkPolyData* contours, const Function& call)
{
  for (vtkCellArray* cells : { contours->GetLines(), contours->GetPolys() })
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      vtkIdType size;
      const vtkIdType* corners;
      cells->GetCellAtId(i, size, corners);
      for (vtkIdType k = 1; k < size; ++k)
      {
        call(corners[k - 1], corners[k]);
      }
      if (cells == contours->GetPolys())
      {
        call(corners[size - 1], corners[0]);
      }
    }
  }
}

carving::Point GetPoint(vtkPolyData* contours, vtkIdType i)
{
  carving::Point p;
  contours->GetPoint(i, p.data());
  return p;
}

} // namespace

vtkSmartPointer<vtkPolyData> MakePolygons(const std::vector<Loop>& loops)
{
  return MakeContours(loops, true);
}

vtkSmartPointer<vtkPolyData> Polylines(const std::vector<Loop>& loops)
{
  return MakeContours(loops, false);
}

Loop Rectangle(double x0, double y0, double x1, double y1)
{
  return { { x0, y0, 0.0 }, { x1, y0, 0.0 }, { x1, y1, 0.0 }, { x0, y1, 0.0 } };
}

Loop Reversed(Loop loop)
{
  std::reverse(loop.begin(), loop.end());
  return loop;
}

Loop LetterU()
{
  return { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2, 0 }, { 2, 2, 0 }, { 2, 1, 0 }, { 1, 1, 0 },
    { 1, 2, 0 }, { 0, 2, 0 } };
}

Loop Star()
{
  Loop loop;
  for (int i = 0; i < 40; ++i)
  {
    const double angle = i * std::acos(-1.0) / 20.0;
    const double radius = (i % 2 ? 1.0 : 2.0) + 0.5 * std::sin(7.0 * i * i);
    loop.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
  }
  return loop;
}

std::multiset<std::pair<carving::Point, carving::Point>> Edges(vtkPolyData* contours)
{
  std::multiset<std::pair<carving::Point, carving::Point>> result;
  ForEachEdge(contours,
    [&](vtkIdType from, vtkIdType to)
    { result.emplace(GetPoint(contours, from), GetPoint(contours, to)); });
  return result;
}

double Area(vtkPolyData* contours)
{
  double sum = 0.0;
  for (const auto& [a, b] : Edges(contours))
  {
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

std::vector<std::pair<int, int>> Degrees(vtkPolyData* contours)
{
  std::vector<std::pair<int, int>> result(contours->GetNumberOfPoints());
  ForEachEdge(contours,
    [&](vtkIdType from, vtkIdType to)
    {
      ++result[from].second;
      ++result[to].first;
    });
  return result;
}
