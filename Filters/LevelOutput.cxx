// SPDX-License-Identifier: BSD-3-Clause
#include "LevelOutput.h"

#include "ArrayTools.h"
#include "Manifold.h"
#include "StreamOutput.h"
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

} // namespace

template <int D>
void FillLevel(const carving::StoredStream<D>& stream, const carving::Profile& profile,
  vtkUnstructuredGrid* grid, int step, bool manifold, vtkPolyData* output)
{
  const carving::Level<D> level = carving::ExtractLevel(stream, step);
  const carving::ManifoldLevel<D> cut =
    manifold ? carving::CutIntoManifold(stream, level) : carving::KeepUncut(level);

  const vtkIdType numberOfPoints = static_cast<vtkIdType>(cut.Points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(numberOfPoints);
  vtkNew<vtkIdList> pointIds;
  pointIds->SetNumberOfIds(numberOfPoints);
  int newVertices = 0;
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    const int point = cut.Points[i];
    points->SetPoint(i, stream.Mesh.Surface.Points[point].data());
    pointIds->SetId(i, point);
    // Copies of a point that cutting made lie side by side and count once.
    const bool first = i == 0 || cut.Points[i - 1] != point;
    newVertices += first && stream.Mesh.Surface.PointSources[point] < 0;
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
  for (const char* name : { StreamArrays::Step, StreamArrays::Region, StreamArrays::SolidSides,
         StreamArrays::SolidTurns })
  {
    output->GetCellData()->CopyFieldOff(name); // what only a stream has
  }
  CopyTuples(grid->GetCellData(), cellIds, output->GetCellData());

  vtkFieldData* fieldData = output->GetFieldData();
  AddFieldValue<vtkIntArray>(fieldData, "Step", step);
  AddFieldValue<vtkIdTypeArray>(fieldData, "Vertices", profile.Vertices[step]);
  AddFieldValue<vtkIdTypeArray>(fieldData, "NewVertices", newVertices);
  AddFieldValue<vtkIdTypeArray>(fieldData, "Triangles", numberOfFaces);
  AddFieldValue<vtkStringArray>(fieldData, "Kind", "carved");
  if (vtkAbstractArray* rung = grid->GetFieldData()->GetAbstractArray(StreamArrays::Rung))
  {
    fieldData->AddArray(rung);
  }
  AddFieldValue<vtkDoubleArray>(fieldData, "FeatureSize", profile.FeatureSize[step]);
}

template void FillLevel<2>(const carving::StoredStream<2>&, const carving::Profile&,
  vtkUnstructuredGrid*, int, bool, vtkPolyData*);
template void FillLevel<3>(const carving::StoredStream<3>&, const carving::Profile&,
  vtkUnstructuredGrid*, int, bool, vtkPolyData*);
