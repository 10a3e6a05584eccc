// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/LevelOutput.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayTools.h"

#include "Core/Surface/Manifold.h"
#include "Core/Surface/SurfaceTopology.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <initializer_list>
#include <limits>
#include <numeric>

namespace
{

void CopyTuples(vtkDataSetAttributes* from, vtkIdList* ids, vtkDataSetAttributes* to)
{
  const vtkIdType count = ids->GetNumberOfIds();
  vtkNew<vtkIdList> all;
  all->SetNumberOfIds(count);
  std::iota(all->begin(), all->end(), 0);
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  to->CopyData(from, ids, all);
}

/** Betti numbers of the closed complex, or what stands for unknown. */
struct ClosedTopology
{
  int Components = -1;
  int Tunnels = -1;
  int Voids = -1;
};

void FillTopology(const ClosedTopology& closed, int dimension,
  const carving::SurfaceTopology& surface, vtkFieldData* fieldData)
{
  AddFieldValue<vtkIntArray>(fieldData, LevelArrays::Components, closed.Components);
  AddFieldValue<vtkIntArray>(fieldData, LevelArrays::Tunnels, closed.Tunnels);
  AddFieldValue<vtkIntArray>(fieldData, LevelArrays::Voids, closed.Voids);
  AddFieldValue<vtkIntArray>(fieldData, LevelArrays::SurfaceComponents, surface.Components);
  if (dimension == 3)
  {
    AddFieldValue<vtkIntArray>(fieldData, LevelArrays::SurfaceGenus, surface.Genus);
  }
}

/** Without a cut a surface need not be a manifold, which has a genus. */
carving::SurfaceTopology MeasureLevel(const carving::ManifoldLevel<3>& level, bool manifold)
{
  return manifold ? carving::MeasureSurface(level)
                  : carving::SurfaceTopology{ carving::CountSurfaceComponents(level), -1 };
}

carving::SurfaceTopology MeasureLevel(const carving::ManifoldLevel<2>& level, bool)
{
  return { carving::CountSurfaceComponents(level), -1 };
}

void FillFieldData(const carving::Profile& profile, int step, const char* kind, int newVertices,
  vtkIdType numberOfFaces, vtkUnstructuredGrid* grid, vtkFieldData* fieldData)
{
  AddFieldValue<vtkIntArray>(fieldData, StreamArrays::Step, step);
  AddFieldValue<vtkIdTypeArray>(fieldData, LevelArrays::Vertices, profile.Vertices[step]);
  AddFieldValue<vtkIdTypeArray>(fieldData, LevelArrays::NewVertices, newVertices);
  AddFieldValue<vtkIdTypeArray>(fieldData, LevelArrays::Triangles, numberOfFaces);
  AddFieldValue<vtkStringArray>(fieldData, LevelArrays::Kind, kind);
  for (const char* name :
    { StreamArrays::Strategy, StreamArrays::KeptDistance, StreamArrays::SnapDistance })
  {
    if (vtkAbstractArray* array = grid->GetFieldData()->GetAbstractArray(name))
    {
      fieldData->AddArray(array);
    }
  }
  AddFieldValue<vtkDoubleArray>(fieldData, LevelArrays::FeatureSize, profile.FeatureSize[step]);
  AddFieldValue<vtkDoubleArray>(fieldData, LevelArrays::Error,
    profile.Error.empty() ? std::numeric_limits<double>::quiet_NaN() : profile.Error[step]);
}

} // namespace

template <int D>
void FillLevel(const carving::StoredStream<D>& stream, const carving::Profile& profile,
  vtkUnstructuredGrid* grid, const carving::Level<D>& level, bool manifold, vtkPolyData* output)
{
  const int step = level.Step;
  const carving::ManifoldLevel<D> cut =
    manifold ? carving::CutIntoManifold(stream, level) : carving::KeepUncut(level);

  const vtkIdType numberOfPoints = static_cast<vtkIdType>(cut.Points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(numberOfPoints);
  vtkNew<vtkIdList> pointIds;
  pointIds->SetNumberOfIds(numberOfPoints);
  vtkDataArray* moved = grid->GetFieldData()->HasArray(StreamArrays::SnapDistance)
    ? grid->GetPointData()->GetArray(StreamArrays::SnapDistance)
    : nullptr;
  int newVertices = 0;
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    const int point = cut.Points[i];
    points->SetPoint(i, stream.Mesh.Surface.Points[point].data());
    pointIds->SetId(i, point);
    // Copies of a point that cutting made lie side by side and count once.
    const bool first = i == 0 || cut.Points[i - 1] != point;
    newVertices += first &&
      (stream.Mesh.Surface.PointSources[point] < 0 || (moved && moved->GetTuple1(point) > 0.0));
  }

  const vtkIdType numberOfFaces = static_cast<vtkIdType>(cut.Faces.size());
  const vtkIdType firstFacet = static_cast<vtkIdType>(stream.Mesh.Cells.size());
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(D * numberOfFaces);
  vtkIdType* to = connectivity->GetPointer(0);
  vtkNew<vtkIdList> cellIds; // a carved face has the data of the cell behind it
  cellIds->SetNumberOfIds(numberOfFaces);
  for (vtkIdType i = 0; i < numberOfFaces; ++i)
  {
    to = std::copy(cut.Faces[i].begin(), cut.Faces[i].end(), to);
    const carving::FaceLife<D>& face = level.Faces[i];
    cellIds->SetId(i,
      face.Constraint >= 0 ? firstFacet + face.Constraint
                           : carving::HalfFace<D>::Cell(face.Behind));
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(D, connectivity);
  output->SetPoints(points);
  if (D == 3)
  {
    output->SetPolys(cells);
  }
  else
  {
    output->SetLines(cells);
  }
  CopyTuples(grid->GetPointData(), pointIds, output->GetPointData());
  for (const char* name : { StreamArrays::Step, StreamArrays::Region, StreamArrays::SolidSides })
  {
    output->GetCellData()->CopyFieldOff(name); // what only a stream has
  }
  CopyTuples(grid->GetCellData(), cellIds, output->GetCellData());

  FillFieldData(profile, step, "carved", newVertices, numberOfFaces, grid, output->GetFieldData());
  FillTopology({ profile.Components[step], profile.Tunnels[step], profile.Voids[step] }, D,
    MeasureLevel(cut, manifold), output->GetFieldData());
}

void FillInputLevel(const carving::ResolvedMesh& mesh, const carving::Profile& profile,
  vtkPolyData* input, const std::vector<vtkIdType>& cellIds, vtkUnstructuredGrid* grid,
  vtkPolyData* output)
{
  const vtkIdType numberOfPoints = static_cast<vtkIdType>(mesh.Points.size());
  const vtkIdType numberOfFaces = static_cast<vtkIdType>(mesh.Facets.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(numberOfPoints);
  vtkNew<vtkIdList> pointIds, faceIds;
  auto originalPoints = MakeArray<vtkIdTypeArray>(StreamArrays::OriginalPoints, numberOfPoints);
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    points->SetPoint(i, mesh.Points[i].data());
    pointIds->InsertNextId(mesh.PointSources[i]);
    originalPoints->SetValue(i, mesh.PointSources[i]);
  }
  vtkNew<vtkCellArray> polys;
  auto originalCells = MakeArray<vtkIdTypeArray>(StreamArrays::OriginalCells, numberOfFaces);
  auto priority = MakeArray<vtkDoubleArray>(StreamArrays::Priority, numberOfFaces);
  auto depth = MakeArray<vtkDoubleArray>(StreamArrays::Depth, numberOfFaces);
  priority->Fill(std::numeric_limits<double>::quiet_NaN());
  depth->Fill(0.0);
  for (vtkIdType i = 0; i < numberOfFaces; ++i)
  {
    const auto& [a, b, c] = mesh.Facets[i];
    polys->InsertNextCell({ a, b, c });
    const vtkIdType original = cellIds[mesh.FacetSources[i]];
    faceIds->InsertNextId(original);
    originalCells->SetValue(i, original);
  }
  output->SetPoints(points);
  output->SetPolys(polys);
  CopyTuples(input->GetPointData(), pointIds, output->GetPointData());
  CopyTuples(input->GetCellData(), faceIds, output->GetCellData());
  output->GetPointData()->AddArray(originalPoints);
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ priority, depth, originalCells })
  {
    output->GetCellData()->AddArray(array);
  }
  FillFieldData(
    profile, profile.LastStep(), "input", 0, numberOfFaces, grid, output->GetFieldData());
  AddFieldValue<vtkIdTypeArray>(output->GetFieldData(), LevelArrays::Vertices, numberOfPoints);
  if (!profile.Error.empty())
  {
    AddFieldValue<vtkDoubleArray>(output->GetFieldData(), LevelArrays::Error, 0.0);
  }
  FillTopology({}, 3, { -1, -1 }, output->GetFieldData());
}

template void FillLevel<2>(const carving::StoredStream<2>&, const carving::Profile&,
  vtkUnstructuredGrid*, const carving::Level<2>&, bool, vtkPolyData*);
template void FillLevel<3>(const carving::StoredStream<3>&, const carving::Profile&,
  vtkUnstructuredGrid*, const carving::Level<3>&, bool, vtkPolyData*);
