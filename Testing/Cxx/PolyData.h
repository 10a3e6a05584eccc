// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meshes as data of VTK.
 */
#ifndef PolyData_h
#define PolyData_h

#include "Core/Mesh/Mesh.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

inline vtkSmartPointer<vtkPolyData> ToPolyData(const carving::TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const carving::Point& p : mesh.Points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> polys;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    polys->InsertNextCell({ a, b, c });
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(polys);
  return result;
}

#endif
