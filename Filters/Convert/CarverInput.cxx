// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/CarverInput.h"

#include "Convert/InputCells.h"
#include "Convert/PolygonCutter.h"
#include "Core/Mesh/LargePages.h"
#include "Core/Protocol/Protocol.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTriangleStrip.h"

std::string CarverInput::Gather(vtkPolyData* input)
{
  *this = {};
  const std::string error = CheckCells(input, { input->GetPolys(), input->GetStrips() });
  if (!error.empty())
  {
    return error;
  }
  if (input->GetNumberOfVerts() > 0 || input->GetNumberOfLines() > 0)
  {
    this->Notes.push_back("Vertices and lines bound no volume: " +
      std::to_string(input->GetNumberOfVerts() + input->GetNumberOfLines()) +
      " cells were ignored.");
  }
  if (input->GetNumberOfPolys() == 0 && input->GetNumberOfStrips() == 0)
  {
    return {};
  }
  this->Mesh.Points = carving::MakeLarge<carving::Point>(input->GetNumberOfPoints());
  carving::ReserveLarge(this->Mesh.Triangles, input->GetNumberOfPolys()); // at least
  carving::ReserveLarge(this->CellIds, input->GetNumberOfPolys());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoint(i, this->Mesh.Points[i].data());
  }
  const vtkIdType visible = this->AddPolygons(input) + this->AddStrips(input);
  return this->IsEmpty() && visible > 0 ? carving::NothingToCarve : "";
}

/** Returns the number of visible polygons. */
vtkIdType CarverInput::AddPolygons(vtkPolyData* input)
{
  vtkIdType visible = 0;
  PolygonCutter cutter(input->GetPoints());
  VisitCells(input, { input->GetPolys() },
    [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
    {
      ++visible;
      this->AddTriangles(cell, cutter.Cut(size, corners));
    });
  if (cutter.GetNumberOfFans() > 0)
  {
    this->Notes.push_back(std::to_string(cutter.GetNumberOfFans()) +
      " polygons cross themselves or have no area: they were cut into fans of triangles.");
  }
  return visible;
}

/** Returns the number of visible strips. */
vtkIdType CarverInput::AddStrips(vtkPolyData* input)
{
  vtkIdType visible = 0;
  vtkNew<vtkCellArray> triangles;
  VisitCells(input, { input->GetStrips() },
    [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
    {
      ++visible;
      triangles->Reset();
      vtkTriangleStrip::DecomposeStrip(static_cast<int>(size), corners, triangles);
      this->AddTriangles(cell, triangles);
    });
  return visible;
}

void CarverInput::AddTriangles(vtkIdType cell, vtkCellArray* triangles)
{
  for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
  {
    vtkIdType size;
    const vtkIdType* corners;
    triangles->GetCellAtId(i, size, corners);
    this->Mesh.Triangles.push_back(
      { static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2]) });
    this->CellIds.push_back(cell);
  }
}
