// SPDX-License-Identifier: BSD-3-Clause
#include "StreamInput.h"

#include "StreamOutput.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <tuple>

namespace
{

constexpr const char* Advice = " The stream of a carver (its output port 1) is needed, as it came "
                               "out.";

/** Reads a numeric array with the given number of tuples, or says what is wrong with it. */
template <class Value>
std::string ReadArray(
  vtkFieldData* from, const char* name, vtkIdType count, std::vector<Value>& values)
{
  vtkDataArray* array = from->GetArray(name);
  if (!array)
  {
    return std::string("the array \"") + name + "\" is missing.";
  }
  if (count >= 0 && array->GetNumberOfTuples() != count)
  {
    return std::string("the array \"") + name + "\" has the wrong length.";
  }
  const int components = array->GetNumberOfComponents();
  values.resize(array->GetNumberOfTuples() * components);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      values[i * components + k] = static_cast<Value>(array->GetComponent(i, k));
    }
  }
  return {};
}

/** Cells of the complement come first, facets of M after them. */
template <int D>
bool ReadCells(vtkUnstructuredGrid* grid, carving::Decomposition<D>& mesh)
{
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCellPoints(i, corners);
    if (grid->GetCellType(i) == (D == 3 ? VTK_TETRA : VTK_TRIANGLE) && mesh.Surface.Facets.empty())
    {
      std::copy(corners->begin(), corners->end(), mesh.Cells.emplace_back().begin());
    }
    else if (grid->GetCellType(i) == (D == 3 ? VTK_TRIANGLE : VTK_LINE))
    {
      std::copy(corners->begin(), corners->end(), mesh.Surface.Facets.emplace_back().begin());
    }
    else
    {
      return false;
    }
  }
  return true;
}

void ReadPoints(vtkUnstructuredGrid* grid, std::vector<carving::Point>& points)
{
  points.resize(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPoint(i, points[i].data());
  }
}

/** The part of a cell array that is about cells (`first` 0) or facets. */
template <class Value>
void TakePart(std::vector<Value>& values, std::size_t first, std::size_t count)
{
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
  values.resize(count);
}

} // namespace

int GetStreamDimension(vtkUnstructuredGrid* grid)
{
  const vtkIdType count = grid->GetNumberOfCells();
  if (!grid->GetCellData()->HasArray(StreamArrays::SolidSides) || count == 0)
  {
    return 0;
  }
  return grid->GetCellType(count - 1) == VTK_LINE ? 2 : 3; // the facets of M come last
}

std::string ReadProfile(vtkUnstructuredGrid* grid, carving::Profile& profile)
{
  vtkFieldData* fieldData = grid->GetFieldData();
  std::vector<double> priorities;
  std::vector<int> measure;
  std::string mistake = ReadArray(fieldData, StreamArrays::ProfilePriority, -1, priorities);
  const vtkIdType count = static_cast<vtkIdType>(priorities.size());
  for (const auto& [name, length, values] :
    { std::make_tuple(StreamArrays::Measure, vtkIdType(1), &measure),
      std::make_tuple(StreamArrays::ProfileVertices, count, &profile.Vertices),
      std::make_tuple(StreamArrays::ProfileTriangles, count, &profile.Triangles),
      std::make_tuple(StreamArrays::ProfileComponents, count, &profile.Components),
      std::make_tuple(StreamArrays::ProfileGenus, count, &profile.Tunnels),
      std::make_tuple(StreamArrays::ProfileVoids, count, &profile.Voids) })
  {
    mistake = mistake.empty() ? ReadArray(fieldData, name, length, *values) : mistake;
  }
  for (const auto& [name, wanted, values] :
    { std::make_tuple(StreamArrays::ProfileVolume, true, &profile.Volume),
      std::make_tuple(StreamArrays::ProfileError,
        fieldData->HasArray(StreamArrays::ProfileError) != 0, &profile.Error) })
  {
    mistake = mistake.empty() && wanted ? ReadArray(fieldData, name, count, *values) : mistake;
  }
  if (mistake.empty() && count == 0)
  {
    mistake = "its profile is empty.";
  }
  if (mistake.empty())
  {
    const auto known = static_cast<carving::PriorityMeasure>(measure[0]);
    GetStreamDimension(grid) == 2 ? carving::SetPriorities<2>(profile, priorities, known)
                                  : carving::SetPriorities<3>(profile, priorities, known);
  }
  return mistake;
}

template <int D>
std::string ReadStream(
  vtkUnstructuredGrid* grid, carving::StoredStream<D>& stream, carving::Profile& profile)
{
  const std::string prefix = "The input is not the stored stream of a carving: ";
  ReadPoints(grid, stream.Mesh.Surface.Points);
  if (!ReadCells(grid, stream.Mesh))
  {
    return prefix + "it has cells of other types." + Advice;
  }
  const vtkIdType count = grid->GetNumberOfCells();
  std::vector<int> measure, both, solidSides;
  vtkCellData* cellData = grid->GetCellData();
  vtkFieldData* fieldData = grid->GetFieldData();
  for (const std::string& mistake :
    { ReadArray(cellData, StreamArrays::Step, count, stream.Order.Step),
      ReadArray(cellData, StreamArrays::Priority, count, stream.Order.Priority),
      ReadArray(cellData, StreamArrays::Depth, count, stream.Order.Depth),
      ReadArray(cellData, StreamArrays::Region, count, stream.Regions),
      ReadArray(cellData, StreamArrays::SolidSides, count, solidSides),
      ReadArray(grid->GetPointData(), StreamArrays::OriginalPoints, grid->GetNumberOfPoints(),
        stream.Mesh.Surface.PointSources),
      ReadArray(fieldData, StreamArrays::Measure, 1, measure),
      ReadArray(fieldData, StreamArrays::BothFoldSides, 1, both), ReadProfile(grid, profile) })
  {
    if (!mistake.empty())
    {
      return prefix + mistake + Advice;
    }
  }
  const std::size_t cells = stream.Mesh.Cells.size();
  const std::size_t facets = stream.Mesh.Surface.Facets.size();
  TakePart(stream.Order.Step, 0, cells);
  TakePart(stream.Order.Priority, 0, cells);
  TakePart(stream.Order.Depth, 0, cells);
  TakePart(stream.Regions, 0, cells);
  TakePart(solidSides, cells, facets);
  for (int& step : stream.Order.Step)
  {
    step = step < 0 ? carving::Stream::Never : step;
  }
  stream.Measure = static_cast<carving::PriorityMeasure>(measure[0]);
  stream.Folds = both[0] != 0 ? carving::FoldSides::Both : carving::FoldSides::One;
  stream.Order.StepPriority = profile.Priority;
  if (!carving::Connect(stream, solidSides))
  {
    return prefix + "its cells do not fit together." + Advice;
  }
  return {};
}

template std::string ReadStream<2>(
  vtkUnstructuredGrid*, carving::StoredStream<2>&, carving::Profile&);
template std::string ReadStream<3>(
  vtkUnstructuredGrid*, carving::StoredStream<3>&, carving::Profile&);
