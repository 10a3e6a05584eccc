// SPDX-License-Identifier: BSD-3-Clause
#include "CarverOutput.h"

#include "Faces.h"
#include "Level.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

template <class ArrayType>
vtkNew<ArrayType> MakeArray(const char* name, vtkIdType size)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfTuples(size);
  return array;
}

template <class ArrayType, class Value>
void AddFieldValue(vtkFieldData* fieldData, const char* name, const Value& value)
{
  vtkNew<ArrayType> array = MakeArray<ArrayType>(name, 1);
  array->SetValue(0, value);
  fieldData->AddArray(array);
}

/** Never is -1 in the output. */
int StepForUser(int step)
{
  return step == carving::Stream::Never ? -1 : step;
}

/** A cell array of cells that all have `N` corners. */
template <int N>
void FillCells(
  const std::vector<std::array<int, N>>& cells, vtkIdTypeArray* connectivity, vtkIdType at)
{
  vtkIdType* to = connectivity->GetPointer(at);
  for (const std::array<int, N>& cell : cells)
  {
    to = std::copy(cell.begin(), cell.end(), to);
  }
}

} // namespace

CarverOutput::CarverOutput(
  const CarvedMesh& carved, vtkPolyData* input, const std::vector<vtkIdType>& cellIds)
  : Carved(carved)
  , Input(input)
  , CellIds(cellIds)
{
  const std::vector<int>& sources = carved.Mesh.Surface.PointSources;
  const vtkIdType numberOfPoints = static_cast<vtkIdType>(sources.size());
  this->PointData->InterpolateAllocate(input->GetPointData(), numberOfPoints);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    if (sources[i] >= 0)
    {
      this->PointData->CopyData(input->GetPointData(), sources[i], i);
    }
  }
  if (std::count(sources.begin(), sources.end(), -1) > 0 &&
    this->PointData->GetNumberOfArrays() > 0)
  {
    this->InterpolateNewPoints();
  }
  vtkNew<vtkIdTypeArray> ids = MakeArray<vtkIdTypeArray>("vtkOriginalPointIds", numberOfPoints);
  std::copy(sources.begin(), sources.end(), ids->Begin());
  this->PointData->AddArray(ids);
}

void CarverOutput::InterpolateNewPoints()
{
  vtkNew<vtkPolyData> surface; // polygons and strips only: nothing else bounds a volume
  surface->SetPoints(this->Input->GetPoints());
  surface->SetPolys(this->Input->GetPolys());
  surface->SetStrips(this->Input->GetStrips());
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(std::max(3, surface->GetMaxCellSize()));
  const carving::ResolvedMesh& mesh = this->Carved.Mesh.Surface;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    if (mesh.PointSources[i] >= 0)
    {
      continue;
    }
    double closest[3], onCell[3], parametric[3], distance;
    vtkIdType cellId = -1;
    int subId = 0;
    locator->FindClosestPoint(mesh.Points[i].data(), closest, cell, cellId, subId, distance);
    surface->GetCell(cellId, cell);
    cell->EvaluatePosition(closest, onCell, subId, parametric, distance, weights.data());
    this->PointData->InterpolatePoint(
      this->Input->GetPointData(), static_cast<vtkIdType>(i), cell->GetPointIds(), weights.data());
  }
}

vtkIdType CarverOutput::GetOriginalCell(int triangle) const
{
  return triangle < 0 ? -1 : this->CellIds[this->Carved.Mesh.Surface.TriangleSources[triangle]];
}

void CarverOutput::FillLevel(int step, vtkPolyData* output) const
{
  const carving::Tetrahedralization& mesh = this->Carved.Mesh;
  const carving::Stream& stream = this->Carved.Stream;
  carving::Level level = carving::ExtractLevel(mesh, stream, step);
  const vtkIdType numberOfTriangles = static_cast<vtkIdType>(level.Triangles.size());

  // Points keep the order that they have in the tetrahedralization.
  std::vector<int> newIds(mesh.Surface.Points.size(), -1);
  for (const carving::Triangle& triangle : level.Triangles)
  {
    for (const int corner : triangle)
    {
      newIds[corner] = 0;
    }
  }
  vtkNew<vtkIdList> oldIds;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  int newVertices = 0;
  for (std::size_t i = 0; i < newIds.size(); ++i)
  {
    if (newIds[i] == 0)
    {
      newIds[i] = static_cast<int>(points->InsertNextPoint(mesh.Surface.Points[i].data()));
      oldIds->InsertNextId(static_cast<vtkIdType>(i));
      newVertices += mesh.Surface.PointSources[i] < 0;
    }
  }
  for (carving::Triangle& triangle : level.Triangles)
  {
    for (int& corner : triangle)
    {
      corner = newIds[corner];
    }
  }
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(3 * numberOfTriangles);
  FillCells<3>(level.Triangles, connectivity, 0);
  vtkNew<vtkCellArray> polys;
  polys->SetData(3, connectivity);
  output->SetPoints(points);
  output->SetPolys(polys);

  const vtkIdType numberOfPoints = points->GetNumberOfPoints();
  vtkNew<vtkIdList> allPoints;
  allPoints->SetNumberOfIds(numberOfPoints);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    allPoints->SetId(i, i);
  }
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(this->PointData, numberOfPoints);
  output->GetPointData()->CopyData(this->PointData, oldIds, allPoints);

  vtkCellData* cellData = output->GetCellData();
  cellData->CopyAllocate(this->Input->GetCellData(), numberOfTriangles);
  auto priority = MakeArray<vtkDoubleArray>("Priority", numberOfTriangles);
  auto depth = MakeArray<vtkDoubleArray>("Depth", numberOfTriangles);
  auto originalCells = MakeArray<vtkIdTypeArray>("vtkOriginalCellIds", numberOfTriangles);
  for (vtkIdType i = 0; i < numberOfTriangles; ++i)
  {
    const vtkIdType original = this->GetOriginalCell(level.Constraints[i]);
    const int behind = level.Constraints[i] < 0 ? level.CellsBehind[i] : -1;
    originalCells->SetValue(i, original);
    priority->SetValue(i, behind < 0 ? NaN : stream.Priority[behind]);
    depth->SetValue(i, behind < 0 ? 0.0 : stream.Depth[behind]);
    if (original >= 0)
    {
      cellData->CopyData(this->Input->GetCellData(), original, i);
    }
    else
    {
      cellData->NullData(i);
    }
  }
  cellData->AddArray(priority);
  cellData->AddArray(depth);
  cellData->AddArray(originalCells);

  vtkFieldData* fieldData = output->GetFieldData();
  AddFieldValue<vtkIntArray>(fieldData, "Step", step);
  AddFieldValue<vtkIdTypeArray>(fieldData, "Vertices", numberOfPoints);
  AddFieldValue<vtkIdTypeArray>(fieldData, "NewVertices", newVertices);
  AddFieldValue<vtkIdTypeArray>(fieldData, "Triangles", numberOfTriangles);
  AddFieldValue<vtkStringArray>(fieldData, "Kind", "carved");
  AddFieldValue<vtkStringArray>(fieldData, "Rung", "TetGen -pcY");
  AddFieldValue<vtkDoubleArray>(fieldData, "FeatureSize", this->Carved.FeatureSizes[step]);
}

void CarverOutput::FillStream(vtkUnstructuredGrid* output) const
{
  const carving::Tetrahedralization& mesh = this->Carved.Mesh;
  const carving::Stream& stream = this->Carved.Stream;
  std::vector<int> complement;
  std::vector<std::array<int, 4>> tetrahedra;
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    if (this->Carved.Regions.Kind(cell) != carving::RegionKind::Solid)
    {
      complement.push_back(cell);
      tetrahedra.push_back(mesh.Cells[cell]);
    }
  }
  std::vector<int> triangleSteps(mesh.Surface.Triangles.size(), carving::Stream::Never);
  carving::ForEachFace(mesh, stream,
    [&](const carving::FaceLife& face)
    {
      if (face.Constraint >= 0)
      {
        triangleSteps[face.Constraint] = face.Birth;
      }
    });

  const vtkIdType numberOfTetrahedra = static_cast<vtkIdType>(tetrahedra.size());
  const vtkIdType numberOfTriangles = static_cast<vtkIdType>(triangleSteps.size());
  const vtkIdType numberOfCells = numberOfTetrahedra + numberOfTriangles;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Surface.Points.size()));
  for (std::size_t i = 0; i < mesh.Surface.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Surface.Points[i].data());
  }
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(4 * numberOfTetrahedra + 3 * numberOfTriangles);
  FillCells<4>(tetrahedra, connectivity, 0);
  FillCells<3>(mesh.Surface.Triangles, connectivity, 4 * numberOfTetrahedra);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(numberOfCells + 1);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(numberOfCells);

  auto priority = MakeArray<vtkDoubleArray>("Priority", numberOfCells);
  auto depth = MakeArray<vtkDoubleArray>("Depth", numberOfCells);
  auto steps = MakeArray<vtkIntArray>("Step", numberOfCells);
  auto region = MakeArray<vtkIntArray>("Region", numberOfCells);
  auto originalCells = MakeArray<vtkIdTypeArray>("vtkOriginalCellIds", numberOfCells);
  vtkCellData* cellData = output->GetCellData();
  cellData->CopyAllocate(this->Input->GetCellData(), numberOfCells);
  offsets->SetValue(0, 0);
  for (vtkIdType i = 0; i < numberOfTetrahedra; ++i)
  {
    const int cell = complement[i];
    offsets->SetValue(i + 1, 4 * (i + 1));
    types->SetValue(i, VTK_TETRA);
    priority->SetValue(i, stream.Priority[cell]);
    depth->SetValue(i, stream.Depth[cell]);
    steps->SetValue(i, StepForUser(stream.Step[cell]));
    region->SetValue(i, this->Carved.Regions.RegionOfCell[cell]);
    originalCells->SetValue(i, -1);
    cellData->NullData(i);
  }
  for (vtkIdType t = 0; t < numberOfTriangles; ++t)
  {
    const vtkIdType i = numberOfTetrahedra + t;
    const vtkIdType original = this->GetOriginalCell(static_cast<int>(t));
    offsets->SetValue(i + 1, 4 * numberOfTetrahedra + 3 * (t + 1));
    types->SetValue(i, VTK_TRIANGLE);
    priority->SetValue(i, NaN);
    depth->SetValue(i, 0.0);
    steps->SetValue(i, StepForUser(triangleSteps[t]));
    region->SetValue(i, -1);
    originalCells->SetValue(i, original);
    cellData->CopyData(this->Input->GetCellData(), original, i);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetPoints(points);
  output->SetCells(types, cells);
  output->GetPointData()->ShallowCopy(this->PointData);
  for (vtkDataArray* array :
    std::initializer_list<vtkDataArray*>{ priority, depth, steps, region, originalCells })
  {
    cellData->AddArray(array);
  }
}

void CarverOutput::FillProfile(vtkTable* output) const
{
  const vtkIdType rows = static_cast<vtkIdType>(this->Carved.Stream.StepPriority.size());
  auto step = MakeArray<vtkIntArray>("Step", rows);
  auto vertices = MakeArray<vtkIntArray>("Vertices", rows);
  auto triangles = MakeArray<vtkIntArray>("Triangles", rows);
  auto priority = MakeArray<vtkDoubleArray>("Priority", rows);
  for (vtkIdType i = 0; i < rows; ++i)
  {
    step->SetValue(i, static_cast<int>(i));
    vertices->SetValue(i, this->Carved.Profile.Vertices[i]);
    triangles->SetValue(i, this->Carved.Profile.Triangles[i]);
    priority->SetValue(i, this->Carved.Stream.StepPriority[i]);
  }
  for (vtkAbstractArray* column :
    std::initializer_list<vtkAbstractArray*>{ step, vertices, triangles, priority })
  {
    output->AddColumn(column);
  }
}
