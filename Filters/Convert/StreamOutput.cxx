// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/StreamOutput.h"

#include "Convert/ArrayTools.h"
#include "Core/Stream/Faces.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellLocator.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace
{

using carving::Decomposition;
using carving::StoredStream;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/** Stream::Never is -1 in the output. */
int StepForUser(int step)
{
  return step == carving::Stream::Never ? -1 : step;
}

/** Gives points that resolving or TetGen made the data of the closest point of the input. */
template <int D>
void InterpolateNewPoints(
  const carving::ResolvedInput<D>& points, vtkPolyData* input, vtkPointData* output)
{
  vtkNew<vtkPolyData> surface; // without cells that bound nothing: vertices and, in space, lines
  surface->SetPoints(input->GetPoints());
  surface->SetPolys(input->GetPolys());
  surface->SetStrips(input->GetStrips());
  if (D == 2)
  {
    surface->SetLines(input->GetLines());
  }
  // Deterministic for equally close cells; the order of vtkStaticCellLocator depends on its
  // threads.
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(std::max(3, surface->GetMaxCellSize()));
  for (std::size_t i = 0; i < points.Points.size(); ++i)
  {
    if (points.PointSources[i] >= 0)
    {
      continue;
    }
    double closest[3], onCell[3], parametric[3], distance;
    vtkIdType cellId = -1;
    int subId = 0;
    locator->FindClosestPoint(points.Points[i].data(), closest, cell, cellId, subId, distance);
    if (cellId < 0)
    {
      continue; // all cells are degenerate
    }
    surface->GetCell(cellId, cell);
    cell->EvaluatePosition(closest, onCell, subId, parametric, distance, weights.data());
    output->InterpolatePoint(
      input->GetPointData(), static_cast<vtkIdType>(i), cell->GetPointIds(), weights.data());
  }
}

/**
 * Adds the arrays of ids, which VTK omits when it interpolates, as plain arrays, since several
 * parts of a cell can have the same id. `source(i)` is the index in the input of entry i, or -1;
 * then the id is -1.
 */
template <class Source>
void AddIdArrays(
  vtkDataSetAttributes* input, vtkIdType count, const Source& source, vtkDataSetAttributes* output)
{
  for (int k = 0; k < input->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* from = input->GetAbstractArray(k);
    if (!from->GetName() || output->HasArray(from->GetName()))
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> to;
    to.TakeReference(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->SetNumberOfTuples(count);
    if (auto* numbers = vtkDataArray::SafeDownCast(to))
    {
      numbers->Fill(-1.0);
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (source(i) >= 0)
      {
        to->SetTuple(i, source(i), from);
      }
    }
    output->AddArray(to);
  }
}

template <int D>
void FillPoints(
  const carving::ResolvedInput<D>& points, vtkPolyData* input, vtkUnstructuredGrid* output)
{
  const vtkIdType count = static_cast<vtkIdType>(points.Points.size());
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  coordinates->SetNumberOfPoints(count);
  auto ids = MakeArray<vtkIdTypeArray>(StreamArrays::OriginalPoints, count);
  auto distances = MakeArray<vtkDoubleArray>(StreamArrays::SnapDistance, count);
  distances->Fill(0.0);
  vtkPointData* pointData = output->GetPointData();
  pointData->InterpolateAllocate(input->GetPointData(), count);
  bool anyNew = false, anyMoved = false;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const int source = points.PointSources[i];
    coordinates->SetPoint(i, points.Points[i].data());
    ids->SetValue(i, source);
    if (source >= 0)
    {
      pointData->CopyData(input->GetPointData(), source, i);
      carving::Point from;
      input->GetPoint(source, from.data());
      distances->SetValue(
        i, std::sqrt(vtkMath::Distance2BetweenPoints(points.Points[i].data(), from.data())));
      anyMoved = anyMoved || points.Points[i] != from;
    }
    anyNew = anyNew || source < 0;
  }
  if (anyNew && pointData->GetNumberOfArrays() > 0)
  {
    InterpolateNewPoints(points, input, pointData);
  }
  AddIdArrays(
    input->GetPointData(), count, [&](vtkIdType i) { return points.PointSources[i]; }, pointData);
  output->SetPoints(coordinates);
  pointData->AddArray(ids);
  if (anyMoved && D == 3) // restoring the plane of contours may move their points, too
  {
    pointData->AddArray(distances);
  }
}

/** The cells of the complement, then the facets of M. */
template <int D>
void FillCells(const Decomposition<D>& mesh, vtkUnstructuredGrid* output)
{
  const vtkIdType cells = static_cast<vtkIdType>(mesh.Cells.size());
  const vtkIdType facets = static_cast<vtkIdType>(mesh.Surface.Facets.size());
  vtkNew<vtkIdTypeArray> connectivity, offsets;
  connectivity->SetNumberOfValues((D + 1) * cells + D * facets);
  offsets->SetNumberOfValues(cells + facets + 1);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(cells + facets);
  vtkIdType* to = connectivity->GetPointer(0);
  vtkIdType i = 0;
  const auto append = [&](const auto& corners, unsigned char type)
  {
    offsets->SetValue(i, to - connectivity->GetPointer(0));
    types->SetValue(i++, type);
    to = std::copy(corners.begin(), corners.end(), to);
  };
  for (const auto& cell : mesh.Cells)
  {
    append(cell, D == 3 ? VTK_TETRA : VTK_TRIANGLE);
  }
  for (const auto& facet : mesh.Surface.Facets)
  {
    append(facet, D == 3 ? VTK_TRIANGLE : VTK_LINE);
  }
  offsets->SetValue(i, to - connectivity->GetPointer(0));
  vtkNew<vtkCellArray> all;
  all->SetData(offsets, connectivity);
  output->SetCells(types, all);
}

template <int D>
std::vector<int> FindFacetSteps(const StoredStream<D>& stream)
{
  std::vector<int> steps;
  for (const auto& [behind, inFront] : stream.Sides)
  {
    steps.push_back(std::min(carving::StepAt(stream, behind), carving::StepAt(stream, inFront)));
  }
  return steps;
}

template <int D>
void FillCellData(const StoredStream<D>& stream, vtkPolyData* input,
  const std::vector<vtkIdType>& cellIds, vtkCellData* output)
{
  const vtkIdType cells = static_cast<vtkIdType>(stream.Mesh.Cells.size());
  const vtkIdType facets = static_cast<vtkIdType>(stream.Sides.size());
  const vtkIdType count = cells + facets;
  auto priority = MakeArray<vtkDoubleArray>(StreamArrays::Priority, count);
  auto depth = MakeArray<vtkDoubleArray>(StreamArrays::Depth, count);
  auto steps = MakeArray<vtkIntArray>(StreamArrays::Step, count);
  auto region = MakeArray<vtkIntArray>(StreamArrays::Region, count);
  auto solidSides = MakeArray<vtkIntArray>(StreamArrays::SolidSides, count);
  auto originalCells = MakeArray<vtkIdTypeArray>(StreamArrays::OriginalCells, count);
  solidSides->Fill(0);
  output->CopyAllocate(input->GetCellData(), count);
  for (vtkIdType i = 0; i < cells; ++i)
  {
    priority->SetValue(i, stream.Order.Priority[i]);
    depth->SetValue(i, stream.Order.Depth[i]);
    steps->SetValue(i, StepForUser(stream.Order.Step[i]));
    region->SetValue(i, stream.Regions[i]);
    originalCells->SetValue(i, -1);
    output->NullData(i);
  }
  const std::vector<int> facetSteps = FindFacetSteps(stream);
  const std::vector<int> sides = carving::GetSolidSides(stream);
  for (vtkIdType facet = 0; facet < facets; ++facet)
  {
    const vtkIdType i = cells + facet;
    const vtkIdType original = cellIds[stream.Mesh.Surface.FacetSources[facet]];
    priority->SetValue(i, NaN);
    depth->SetValue(i, 0.0);
    steps->SetValue(i, StepForUser(facetSteps[facet]));
    region->SetValue(i, -1);
    solidSides->SetValue(i, sides[facet]);
    originalCells->SetValue(i, original);
    output->CopyData(input->GetCellData(), original, i);
  }
  AddIdArrays(
    input->GetCellData(), count, [&](vtkIdType i) { return originalCells->GetValue(i); }, output);
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{
         priority, depth, steps, region, solidSides, originalCells })
  {
    output->AddArray(array);
  }
}

} // namespace

template <int D>
void FillStream(const StoredStream<D>& stream, const carving::Profile& profile, vtkPolyData* input,
  const std::vector<vtkIdType>& cellIds, vtkUnstructuredGrid* output)
{
  FillPoints(stream.Mesh.Surface, input, output);
  FillCells(stream.Mesh, output);
  FillCellData(stream, input, cellIds, output->GetCellData());
  vtkFieldData* fieldData = output->GetFieldData();
  AddFieldValue<vtkIntArray>(fieldData, StreamArrays::Measure, static_cast<int>(stream.Measure));
  AddFieldValue<vtkIntArray>(
    fieldData, StreamArrays::BothFoldSides, stream.Folds == carving::FoldSides::Both);
  AddFieldArray<vtkIntArray>(fieldData, StreamArrays::ProfileVertices, profile.Vertices);
  AddFieldArray<vtkIntArray>(fieldData, StreamArrays::ProfileTriangles, profile.Triangles);
  AddFieldArray<vtkIntArray>(fieldData, StreamArrays::ProfileComponents, profile.Components);
  AddFieldArray<vtkIntArray>(fieldData, StreamArrays::ProfileTunnels, profile.Tunnels);
  AddFieldArray<vtkIntArray>(fieldData, StreamArrays::ProfileVoids, profile.Voids);
  AddFieldArray<vtkDoubleArray>(fieldData, StreamArrays::ProfileVolume, profile.Volume);
  AddFieldArray<vtkDoubleArray>(fieldData, StreamArrays::ProfilePriority, profile.Priority);
  if (!profile.Error.empty())
  {
    AddFieldArray<vtkDoubleArray>(fieldData, StreamArrays::ProfileError, profile.Error);
  }
}

template void FillStream<2>(const StoredStream<2>&, const carving::Profile&, vtkPolyData*,
  const std::vector<vtkIdType>&, vtkUnstructuredGrid*);
template void FillStream<3>(const StoredStream<3>&, const carving::Profile&, vtkPolyData*,
  const std::vector<vtkIdType>&, vtkUnstructuredGrid*);

void FillProfile(const carving::Profile& profile, vtkTable* output)
{
  std::vector<int> steps(profile.Vertices.size());
  std::iota(steps.begin(), steps.end(), 0);
  vtkFieldData* columns = output->GetRowData();
  AddFieldArray<vtkIntArray>(columns, StreamArrays::Step, steps);
  AddFieldArray<vtkIntArray>(columns, LevelArrays::Vertices, profile.Vertices);
  AddFieldArray<vtkIntArray>(columns, LevelArrays::Triangles, profile.Triangles);
  AddFieldArray<vtkIntArray>(columns, LevelArrays::Components, profile.Components);
  AddFieldArray<vtkIntArray>(columns, LevelArrays::Tunnels, profile.Tunnels);
  AddFieldArray<vtkIntArray>(columns, LevelArrays::Voids, profile.Voids);
  AddFieldArray<vtkDoubleArray>(columns, ProfileArrays::Priority, profile.Priority);
  AddFieldArray<vtkDoubleArray>(columns, ProfileArrays::Volume, profile.Volume);
  AddFieldArray<vtkDoubleArray>(columns, LevelArrays::Error,
    profile.Error.empty() ? std::vector<double>(profile.Vertices.size(), NaN) : profile.Error);
}
