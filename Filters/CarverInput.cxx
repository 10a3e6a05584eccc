// SPDX-License-Identifier: BSD-3-Clause
#include "CarverInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace
{

constexpr const char* CellIdName = "TopologyCarvingCellId";

/** Triangles only, with the cells they come from as an array. */
void Triangulate(vtkPolyData* input, vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(CellIdName);
  ids->SetNumberOfTuples(input->GetNumberOfCells());
  std::iota(ids->Begin(), ids->End(), 0);
  vtkNew<vtkPolyData> numbered;
  numbered->CopyStructure(input);
  numbered->GetCellData()->AddArray(ids);
  numbered->GetCellData()->AddArray(input->GetCellGhostArray());
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->SetInputData(numbered);
  triangulate->Update();
  output->ShallowCopy(triangulate->GetOutput());
}

std::string CheckFinite(const carving::TriangleMesh& mesh)
{
  for (const carving::Triangle& triangle : mesh.Triangles)
  {
    for (const int corner : triangle)
    {
      const carving::Point& p = mesh.Points[corner];
      if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
      {
        std::ostringstream error;
        error << "Point " << corner << " is (" << p[0] << ", " << p[1] << ", " << p[2]
              << "): coordinates must be finite. Remove the cells that use it.";
        return error.str();
      }
    }
  }
  return {};
}

} // namespace

std::string CarverInput::Gather(vtkPolyData* input)
{
  *this = {};
  if (input->GetNumberOfPoints() > VTK_INT_MAX || input->GetNumberOfCells() > VTK_INT_MAX)
  {
    return "The mesh has more points or cells than a 32-bit integer can count.";
  }
  if (input->GetNumberOfVerts() > 0 || input->GetNumberOfLines() > 0)
  {
    this->Notes.push_back("Vertices and lines bound no volume: " +
      std::to_string(input->GetNumberOfVerts() + input->GetNumberOfLines()) +
      " cells were passed over.");
  }
  if (input->GetNumberOfPolys() == 0 && input->GetNumberOfStrips() == 0)
  {
    return {};
  }
  vtkNew<vtkPolyData> triangulated;
  Triangulate(input, triangulated);
  const vtkIdType* ids =
    vtkIdTypeArray::SafeDownCast(triangulated->GetCellData()->GetArray(CellIdName))->GetPointer(0);
  vtkUnsignedCharArray* ghosts = triangulated->GetCellGhostArray();
  constexpr unsigned char skipped =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;

  this->Mesh.Points.resize(input->GetNumberOfPoints());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoint(i, this->Mesh.Points[i].data());
  }
  vtkCellArray* triangles = triangulated->GetPolys();
  const vtkIdType numberOfTriangles = triangles->GetNumberOfCells();
  this->Mesh.Triangles.reserve(numberOfTriangles);
  this->CellIds.reserve(numberOfTriangles);
  for (vtkIdType i = 0; i < numberOfTriangles; ++i)
  {
    if (ghosts && (ghosts->GetValue(i) & skipped))
    {
      continue;
    }
    vtkIdType size;
    const vtkIdType* corners;
    triangles->GetCellAtId(i, size, corners);
    this->Mesh.Triangles.push_back(
      { static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2]) });
    this->CellIds.push_back(ids[i]);
  }
  return CheckFinite(this->Mesh);
}
