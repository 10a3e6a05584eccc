// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/LevelOutput.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayTools.h"
#include "Convert/CellArrays.h"
#include "Convert/PointOutput.h"
#include "Core/Mesh/LargePages.h"
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

#include <algorithm>
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
  ProvidePagesOf(to, count);
  to->CopyData(from, ids, all);
}

/** Betti numbers of the closed complex; -1 means unknown. */
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

/** A surface that has not been cut need not be a manifold; then it has no genus. */
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
    { StreamArrays::Strategy, StreamArrays::KeptDistance, StreamArrays::KeptDistance99,
      StreamArrays::KeptDistanceMean, StreamArrays::MetShare, StreamArrays::SnapDistance })
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

/**
 * Returns the number of vertices that are not vertices of the input; copies of a point count once.
 */
template <int D>
int FillStreamPoints(const carving::ResolvedInput<D>& resolved, const std::vector<int>& ids,
  vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(ids.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkIdList> pointIds;
  pointIds->SetNumberOfIds(count);
  vtkDataArray* moved = grid->GetFieldData()->HasArray(StreamArrays::SnapDistance)
    ? grid->GetPointData()->GetArray(StreamArrays::SnapDistance)
    : nullptr;
  int newVertices = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const int point = ids[i];
    points->SetPoint(i, resolved.Points[point].data());
    pointIds->SetId(i, point);
    const bool first = i == 0 || ids[i - 1] != point; // copies of a point are neighbors
    newVertices +=
      first && (resolved.PointSources[point] < 0 || (moved && moved->GetComponent(point, 0) > 0.0));
  }
  output->SetPoints(points);
  CopyTuples(grid->GetPointData(), pointIds, output->GetPointData());
  return newVertices;
}

/** `cells` has the cell of the stream with the data of each face. */
template <int D>
void FillFaces(const std::vector<std::array<int, D>>& corners, const std::vector<int>& cells,
  vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  vtkNew<vtkCellArray> faces;
  FillCellArray(corners, faces);
  if (D == 3)
  {
    output->SetPolys(faces);
  }
  else
  {
    output->SetLines(faces);
  }
  for (const char* name : { StreamArrays::Step, StreamArrays::Region, StreamArrays::SolidSides })
  {
    output->GetCellData()->CopyFieldOff(name); // of the stream only
  }
  vtkNew<vtkIdList> cellIds;
  cellIds->SetNumberOfIds(static_cast<vtkIdType>(cells.size()));
  std::copy(cells.begin(), cells.end(), cellIds->begin());
  CopyTuples(grid->GetCellData(), cellIds, output->GetCellData());
}

/** Fills the triangles of M as given, or their pieces where M crosses itself. */
void FillInputFaces(const carving::ResolvedMesh& mesh, const std::vector<vtkIdType>& cellIds,
  vtkCellData* inputData, vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(mesh.Facets.size());
  vtkNew<vtkCellArray> polys;
  FillCellArray(mesh.Facets, polys);
  vtkNew<vtkIdList> ids;
  auto originals = MakeArray<vtkIdTypeArray>(StreamArrays::OriginalCells, count);
  auto priority = MakeArray<vtkDoubleArray>(StreamArrays::Priority, count);
  auto depth = MakeArray<vtkDoubleArray>(StreamArrays::Depth, count);
  priority->Fill(std::numeric_limits<double>::quiet_NaN());
  depth->Fill(0.0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType original = cellIds[mesh.FacetSources[i]];
    ids->InsertNextId(original);
    originals->SetValue(i, original);
  }
  output->SetPolys(polys);
  CopyTuples(inputData, ids, output->GetCellData());
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ priority, depth, originals })
  {
    output->GetCellData()->AddArray(array);
  }
}

} // namespace

template <int D>
void FillLevel(const carving::StoredStream<D>& stream, const carving::Profile& profile,
  vtkUnstructuredGrid* grid, const carving::Level<D>& level, bool manifold, vtkPolyData* output)
{
  const int step = level.Step;
  const carving::ManifoldLevel<D> cut =
    manifold ? carving::CutIntoManifold(stream, level) : carving::KeepUncut(level);
  const int newVertices = FillStreamPoints<D>(stream.Mesh.Surface, cut.Points, grid, output);
  std::vector<int> cells;
  carving::ReserveLarge(cells, level.Faces.size());
  for (const carving::FaceLife<D>& face : level.Faces)
  {
    cells.push_back(carving::CellWithDataOf(stream, face));
  }
  FillFaces<D>(cut.Faces, cells, grid, output);
  FillFieldData(profile, step, "carved", newVertices, static_cast<vtkIdType>(cut.Faces.size()),
    grid, output->GetFieldData());
  FillTopology({ profile.Components[step], profile.Tunnels[step], profile.Voids[step] }, D,
    MeasureLevel(cut, manifold), output->GetFieldData());
}

std::string FillSimplifiedLevel(const carving::StoredStream<3>& stream,
  const carving::SimplifiedStream& simplified, const carving::Profile& profile,
  vtkUnstructuredGrid* grid, const carving::SimplifiedTarget& target, bool manifold,
  vtkPolyData* output)
{
  const auto fillCarved = [&](int step)
  { FillLevel(stream, profile, grid, carving::ExtractLevel(stream, step), manifold, output); };
  if (carving::IsMetByCarving(profile, target))
  {
    fillCarved(target.LastStep);
    return {};
  }
  const auto [level, problem] = carving::SelectSimplifiedLevel(simplified, target);
  const int within =
    problem.empty() ? -1 : carving::FindCarvedStepWithin(simplified, profile, target);
  if (within >= 0)
  {
    fillCarved(within);
    return {};
  }
  if (level.Chain < 0)
  {
    fillCarved(
      std::min(target.LastStep, carving::SelectStep(profile, target.Type, target.Value).Step));
    return problem;
  }
  const carving::DecimatedStep& from = simplified.Steps[level.Chain];
  const carving::CollapsedSurface surface = carving::ExtractSurface(from.Chain, level.Collapses);
  std::vector<int> points;
  for (const int point : surface.Points)
  {
    points.push_back(from.Points[point]);
  }
  const int newVertices = FillStreamPoints<3>(stream.Mesh.Surface, points, grid, output);
  FillFaces<3>(surface.Triangles, surface.Sources, grid, output);
  vtkFieldData* fieldData = output->GetFieldData();
  FillFieldData(profile, from.Step, "simplified", newVertices,
    static_cast<vtkIdType>(surface.Triangles.size()), grid, fieldData);
  AddFieldValue<vtkIdTypeArray>(
    fieldData, LevelArrays::Vertices, static_cast<vtkIdType>(points.size()));
  AddFieldValue<vtkDoubleArray>(fieldData, LevelArrays::Error, level.Error);
  const int step = from.Step;
  FillTopology({ profile.Components[step], profile.Tunnels[step], profile.Voids[step] }, 3,
    { from.SurfaceComponents, from.SurfaceGenus }, fieldData);
  return problem;
}

void FillInputLevel(const carving::Tetrahedralization& result, const carving::Profile& profile,
  vtkPolyData* input, const std::vector<vtkIdType>& cellIds, vtkUnstructuredGrid* grid,
  vtkPolyData* output)
{
  const carving::ResolvedMesh& mesh = result.Unresolved;
  FillPoints<3>(mesh, input, output);
  FillInputFaces(mesh, cellIds, input->GetCellData(), output);
  AddFieldArray<vtkDoubleArray>(output->GetCellData(), StreamArrays::MetShare, result.MetShares);
  vtkFieldData* fieldData = output->GetFieldData();
  const auto newVertices = std::count(mesh.PointSources.begin(), mesh.PointSources.end(), -1);
  FillFieldData(profile, profile.LastStep(), "input", static_cast<int>(newVertices),
    static_cast<vtkIdType>(mesh.Facets.size()), grid, fieldData);
  AddFieldValue<vtkIdTypeArray>(
    fieldData, LevelArrays::Vertices, static_cast<vtkIdType>(mesh.Points.size()));
  if (!profile.Error.empty())
  {
    AddFieldValue<vtkDoubleArray>(fieldData, LevelArrays::Error, 0.0);
  }
  FillTopology({}, 3, { -1, -1 }, fieldData);
}

template void FillLevel<2>(const carving::StoredStream<2>&, const carving::Profile&,
  vtkUnstructuredGrid*, const carving::Level<2>&, bool, vtkPolyData*);
template void FillLevel<3>(const carving::StoredStream<3>&, const carving::Profile&,
  vtkUnstructuredGrid*, const carving::Level<3>&, bool, vtkPolyData*);
