// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/StreamOutput.h"

#include "Convert/ArrayTools.h"
#include "Convert/CellArrays.h"
#include "Convert/PointOutput.h"
#include "Core/Stream/Faces.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
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

/** The cells of the complement, then the facets of M. */
template <int D>
void FillCells(const Decomposition<D>& mesh, vtkUnstructuredGrid* output)
{
  const vtkIdType cells = static_cast<vtkIdType>(mesh.Cells.size());
  const vtkIdType facets = static_cast<vtkIdType>(mesh.Surface.Facets.size());
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(cells + facets);
  std::fill_n(types->GetPointer(0), cells, D == 3 ? VTK_TETRA : VTK_TRIANGLE);
  std::fill_n(types->GetPointer(cells), facets, D == 3 ? VTK_TRIANGLE : VTK_LINE);
  vtkNew<vtkCellArray> all;
  FillCellArray(mesh.Cells, all, mesh.Surface.Facets);
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

/**
 * Copies the values of cells into an array that has the same value for all facets. Releases the
 * memory of the copied values, so that few of a stream's arrays are in memory twice at a time.
 */
template <class Array, class Value>
vtkNew<Array> TakeArray(const char* name, vtkIdType count, std::vector<Value>& ofCells,
  typename Array::ValueType ofFacets)
{
  vtkNew<Array> array = MakeArray<Array>(name, count);
  auto* const facets = std::copy(ofCells.begin(), ofCells.end(), array->GetPointer(0));
  std::fill(facets, array->GetPointer(count), ofFacets);
  ofCells = std::vector<Value>(); // {} would keep the memory
  return array;
}

template <int D>
void FillCellData(StoredStream<D>& stream, vtkPolyData* input,
  const std::vector<vtkIdType>& cellIds, vtkCellData* output)
{
  const vtkIdType cells = static_cast<vtkIdType>(stream.Mesh.Cells.size());
  const vtkIdType facets = static_cast<vtkIdType>(stream.Sides.size());
  const vtkIdType count = cells + facets;
  auto priority =
    TakeArray<vtkDoubleArray>(StreamArrays::Priority, count, stream.Order.Priority, NaN);
  auto depth = TakeArray<vtkDoubleArray>(StreamArrays::Depth, count, stream.Order.Depth, 0.0);
  auto region = TakeArray<vtkIntArray>(StreamArrays::Region, count, stream.Regions, -1);
  auto steps = MakeArray<vtkIntArray>(StreamArrays::Step, count);
  auto solidSides = MakeArray<vtkIntArray>(StreamArrays::SolidSides, count);
  auto originalCells = MakeArray<vtkIdTypeArray>(StreamArrays::OriginalCells, count);
  solidSides->Fill(0);
  output->CopyAllocate(input->GetCellData(), count);
  for (vtkIdType i = 0; i < cells; ++i)
  {
    steps->SetValue(i, StepForUser(stream.Order.Step[i]));
    originalCells->SetValue(i, -1);
    output->NullData(i);
  }
  const std::vector<int> facetSteps = FindFacetSteps(stream);
  const std::vector<int> sides = carving::GetSolidSides(stream);
  for (vtkIdType facet = 0; facet < facets; ++facet)
  {
    const vtkIdType i = cells + facet;
    const vtkIdType original = cellIds[stream.Mesh.Surface.FacetSources[facet]];
    steps->SetValue(i, StepForUser(facetSteps[facet]));
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
void FillStream(StoredStream<D>& stream, vtkPolyData* input, const std::vector<vtkIdType>& cellIds,
  vtkUnstructuredGrid* output)
{
  FillPoints(stream.Mesh.Surface, input, output);
  FillCells(stream.Mesh, output);
  FillCellData(stream, input, cellIds, output->GetCellData());
  vtkFieldData* fieldData = output->GetFieldData();
  AddFieldValue<vtkIntArray>(fieldData, StreamArrays::Measure, static_cast<int>(stream.Measure));
  AddFieldValue<vtkIntArray>(
    fieldData, StreamArrays::BothFoldSides, stream.Folds == carving::FoldSides::Both);
}

template void FillStream<2>(
  StoredStream<2>&, vtkPolyData*, const std::vector<vtkIdType>&, vtkUnstructuredGrid*);
template void FillStream<3>(
  StoredStream<3>&, vtkPolyData*, const std::vector<vtkIdType>&, vtkUnstructuredGrid*);

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

void AddProfile(vtkTable* profile, bool withErrors, vtkFieldData* fieldData)
{
  const auto add = [&](const char* column, const char* name)
  {
    vtkDataArray* values = profile->GetRowData()->GetArray(column);
    const auto array = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
    array->ShallowCopy(values);
    array->SetName(name);
    fieldData->AddArray(array);
  };
  add(LevelArrays::Vertices, StreamArrays::ProfileVertices);
  add(LevelArrays::Triangles, StreamArrays::ProfileTriangles);
  add(LevelArrays::Components, StreamArrays::ProfileComponents);
  add(LevelArrays::Tunnels, StreamArrays::ProfileTunnels);
  add(LevelArrays::Voids, StreamArrays::ProfileVoids);
  add(ProfileArrays::Volume, StreamArrays::ProfileVolume);
  add(ProfileArrays::Priority, StreamArrays::ProfilePriority);
  if (withErrors)
  {
    add(LevelArrays::Error, StreamArrays::ProfileError);
  }
}
