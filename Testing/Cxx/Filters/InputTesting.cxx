// SPDX-License-Identifier: BSD-3-Clause
#include "InputTesting.h"

#include "Core/Mesh/Vector.h"
#include "vtkCellArray.h"

using carving::Point;

vtkSmartPointer<vtkPolyData> MakeMesh(const std::vector<Point>& points, const Polygons& polygons)
{
  vtkSmartPointer<vtkPolyData> mesh = ToPolyData({ points, {} });
  vtkNew<vtkCellArray> polys;
  for (const std::vector<vtkIdType>& polygon : polygons)
  {
    polys->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  mesh->SetPolys(polys);
  return mesh;
}

double GetVolume(vtkPolyData* level)
{
  double volume = 0.0;
  for (const auto& [a, b, c] : GetTriangles(level))
  {
    volume += carving::Dot(a, carving::Cross(b, c)) / 6.0;
  }
  return volume;
}

vtkSmartPointer<vtkPolyData> QuadBoxes(const std::function<Point(const Point&)>& move)
{
  std::vector<Point> points;
  Polygons polygons;
  for (const vtkIdType box : { 0, 1 })
  {
    for (int i = 0; i < 8; ++i)
    {
      points.push_back(move(
        { double(i & 1) + 2.0 * static_cast<double>(box), double(i >> 1 & 1), double(i >> 2) }));
    }
    for (std::vector<vtkIdType> side : Polygons{ { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
           { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
    {
      for (vtkIdType& corner : side)
      {
        corner += 8 * box;
      }
      polygons.push_back(side);
    }
  }
  return MakeMesh(points, polygons);
}
