// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/StreamInput.h"

#include "Convert/ArrayReader.h"
#include "Convert/StreamOutput.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace
{

constexpr int MaxInt = std::numeric_limits<int>::max();

std::string Number(vtkIdType number)
{
  return std::to_string(number);
}

/** Returns an empty string, or what is wrong. */
std::string ReadPoints(vtkUnstructuredGrid* grid, std::vector<carving::Point>& points)
{
  points.resize(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPoint(i, points[i].data());
    if (!std::all_of(points[i].begin(), points[i].end(), [](double x) { return std::isfinite(x); }))
    {
      return "the coordinates of point " + Number(i) + " are not finite.";
    }
  }
  return {};
}

/** Appends a cell, or a facet, of as many corners as it must have. Returns false if it has others. */
template <class Tuple>
bool Append(vtkIdList* corners, std::vector<Tuple>& to)
{
  Tuple& added = to.emplace_back();
  const bool fits = corners->GetNumberOfIds() == static_cast<vtkIdType>(added.size());
  if (fits)
  {
    std::copy(corners->begin(), corners->end(), added.begin());
  }
  return fits;
}

/** Whether what cells are read from hangs together. */
bool AreCellsValid(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  return types->GetNumberOfComponents() == 1 &&
    types->GetNumberOfValues() == grid->GetNumberOfCells() && grid->GetCells()->IsValid();
}

/** Cells of the complement come first, facets of M after them. Returns an empty string, or what is wrong. */
template <int D>
std::string ReadCells(vtkUnstructuredGrid* grid, carving::Decomposition<D>& mesh)
{
  if (!AreCellsValid(grid))
  {
    return "the types, offsets and corners of its cells contradict each other.";
  }
  const vtkIdType numberOfPoints = grid->GetNumberOfPoints();
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const int type = grid->GetCellType(i);
    const bool isFacet = type == (D == 3 ? VTK_TRIANGLE : VTK_LINE);
    const bool isCell = type == (D == 3 ? VTK_TETRA : VTK_TRIANGLE) && mesh.Surface.Facets.empty();
    grid->GetCellPoints(i, corners);
    const auto stray = std::find_if(corners->begin(), corners->end(),
      [=](vtkIdType corner) { return corner < 0 || corner >= numberOfPoints; });
    if (stray != corners->end())
    {
      return "cell " + Number(i) + " has the point " + Number(*stray) + ", but there are " +
        Number(numberOfPoints) + " points.";
    }
    if (!(isFacet && Append(corners, mesh.Surface.Facets)) &&
      !(isCell && Append(corners, mesh.Cells)))
    {
      return "cell " + Number(i) + " is none of a stream's.";
    }
  }
  return {};
}

/** The priorities of cells, or of steps: of some there is none. */
template <class HasPriority>
Demand Priorities(const HasPriority& hasPriority)
{
  return { "a number of at least 0 (NaN where nothing is carved)",
    [=](double value, vtkIdType i) { return hasPriority(i) ? value >= 0.0 : std::isnan(value); } };
}

/** Reads the arrays of a profile. Returns by what the priorities have been measured. */
carving::PriorityMeasure ReadProfile(
  vtkUnstructuredGrid* grid, ArrayReader& reader, carving::Profile& profile)
{
  vtkFieldData* fieldData = grid->GetFieldData();
  vtkAbstractArray* any = fieldData->GetAbstractArray(StreamArrays::ProfilePriority);
  const vtkIdType count = std::clamp<vtkIdType>(any ? any->GetNumberOfTuples() : 0, 1, MaxInt);
  std::vector<double> priorities;
  std::vector<int> measure;
  reader.Read(fieldData, StreamArrays::ProfilePriority, count,
    Priorities([](vtkIdType step) { return step > 0; }), priorities);
  reader.Read(fieldData, StreamArrays::Measure, 1, IntegersFrom(0, 3), measure);
  for (const auto& [name, least, values] :
    { std::make_tuple(StreamArrays::ProfileVertices, 0, &profile.Vertices),
      std::make_tuple(StreamArrays::ProfileTriangles, 0, &profile.Triangles),
      std::make_tuple(StreamArrays::ProfileComponents, 1, &profile.Components),
      std::make_tuple(StreamArrays::ProfileTunnels, 0, &profile.Tunnels),
      std::make_tuple(StreamArrays::ProfileVoids, 0, &profile.Voids) })
  {
    reader.Read(fieldData, name, count, IntegersFrom(least, MaxInt), *values);
  }
  double least = std::numeric_limits<double>::max();
  reader.Read(fieldData, StreamArrays::ProfileVolume, count,
    { "a finite number of at least 0 that is no greater than the one before",
      [&least](double value, vtkIdType)
      {
        const bool isMet = value >= 0.0 && value <= least;
        least = value;
        return isMet;
      } },
    profile.Volume);
  if (fieldData->HasArray(StreamArrays::ProfileError))
  {
    reader.Read(fieldData, StreamArrays::ProfileError, count, FiniteMeasures(), profile.Error);
  }
  const auto known = static_cast<carving::PriorityMeasure>(measure.empty() ? 0 : measure[0]);
  GetStreamDimension(grid) == 2 ? carving::SetPriorities<2>(profile, priorities, known)
                                : carving::SetPriorities<3>(profile, priorities, known);
  return known;
}

/** Reads the arrays of cells, facets and points. Facets come after all cells. */
template <int D>
void ReadOrder(vtkUnstructuredGrid* grid, int lastStep, ArrayReader& reader,
  carving::StoredStream<D>& stream, std::vector<int>& solidSides)
{
  const vtkIdType count = grid->GetNumberOfCells();
  const vtkIdType cells = static_cast<vtkIdType>(stream.Mesh.Cells.size());
  vtkCellData* cellData = grid->GetCellData();
  carving::Stream& order = stream.Order;
  const Demand steps = IntegersFrom(-1, lastStep);
  reader.Read(cellData, StreamArrays::Step, count,
    { steps.What + " (0 for facets of the mesh only)",
      [&](double value, vtkIdType i)
      { return steps.IsMet(value, i) && (value != 0.0 || i >= cells); } },
    order.Step);
  reader.Read(cellData, StreamArrays::Priority, count,
    Priorities([&](vtkIdType i) { return i < cells && order.Step[i] > 0; }), order.Priority);
  reader.Read(cellData, StreamArrays::Depth, count, FiniteMeasures(), order.Depth);
  reader.Read(cellData, StreamArrays::Region, count, IntegersFrom(-1, MaxInt), stream.Regions);
  reader.Read(cellData, StreamArrays::SolidSides, count, IntegersFrom(0, 3), solidSides);
  reader.Read(grid->GetPointData(), StreamArrays::OriginalPoints, grid->GetNumberOfPoints(),
    IntegersFrom(-1, MaxInt), stream.Mesh.Surface.PointSources);
}

/** Checks what levels get as it is. */
void CheckPassedOn(vtkUnstructuredGrid* grid, ArrayReader& reader)
{
  vtkPointData* pointData = grid->GetPointData();
  vtkCellData* cellData = grid->GetCellData();
  vtkFieldData* fieldData = grid->GetFieldData();
  reader.Check(
    cellData, StreamArrays::OriginalCells, grid->GetNumberOfCells(), IntegersFrom(-1, MaxInt));
  reader.CheckLengths(cellData, grid->GetNumberOfCells());
  reader.CheckLengths(pointData, grid->GetNumberOfPoints());
  if (fieldData->HasArray(StreamArrays::Strategy))
  {
    reader.CheckText(fieldData, StreamArrays::Strategy);
  }
  const auto checkIfThere = [&](vtkFieldData* from, const char* name, vtkIdType tuples)
  {
    if (from->HasArray(name))
    {
      reader.Check(from, name, tuples, FiniteMeasures());
    }
  };
  checkIfThere(fieldData, StreamArrays::KeptDistance, 1);
  checkIfThere(fieldData, StreamArrays::SnapDistance, 1);
  if (fieldData->HasArray(StreamArrays::SnapDistance)) // else it is data of the input's own
  {
    checkIfThere(pointData, StreamArrays::SnapDistance, grid->GetNumberOfPoints());
  }
}

/** The part of a cell array that is about cells (`first` 0) or facets. */
template <class Value>
void TakePart(std::vector<Value>& values, std::size_t first, std::size_t count)
{
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
  values.resize(count);
}

/** Returns an empty string, or what is wrong. */
template <int D>
std::string ReadParts(
  vtkUnstructuredGrid* grid, carving::StoredStream<D>& stream, carving::Profile& profile)
{
  // A face of a cell has a number, too.
  if (grid->GetNumberOfPoints() > MaxInt || grid->GetNumberOfCells() > MaxInt / (D + 1))
  {
    return "it has more points or cells than a 32-bit integer can count.";
  }
  std::string mistake = ReadPoints(grid, stream.Mesh.Surface.Points);
  mistake = mistake.empty() ? ReadCells(grid, stream.Mesh) : mistake;
  if (!mistake.empty())
  {
    return mistake;
  }
  ArrayReader reader;
  std::vector<int> both, solidSides;
  reader.Read(grid->GetFieldData(), StreamArrays::BothFoldSides, 1, IntegersFrom(0, 1), both);
  stream.Measure = ReadProfile(grid, reader, profile);
  ReadOrder(grid, profile.LastStep(), reader, stream, solidSides);
  CheckPassedOn(grid, reader);
  if (!reader.GetMistake().empty())
  {
    return reader.GetMistake();
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
  stream.Folds = both[0] != 0 ? carving::FoldSides::Both : carving::FoldSides::One;
  stream.Order.StepPriority = profile.Priority;
  if (!carving::Connect(stream, solidSides))
  {
    return "its cells do not fit together.";
  }
  const carving::Profile found = carving::ComputeProfile(stream);
  if (found.Vertices != profile.Vertices)
  {
    reader.Refuse(StreamArrays::ProfileVertices, "contradicts the cells");
  }
  if (found.Triangles != profile.Triangles)
  {
    reader.Refuse(StreamArrays::ProfileTriangles, "contradicts the cells");
  }
  return reader.GetMistake();
}

} // namespace

int GetStreamDimension(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  const vtkIdType count = types ? types->GetNumberOfValues() : 0;
  return count > 0 && types->GetValue(count - 1) == VTK_LINE ? 2 : 3; // the facets of M come last
}

std::string ReadProfile(vtkUnstructuredGrid* grid, carving::Profile& profile)
{
  ArrayReader reader;
  ReadProfile(grid, reader, profile);
  return reader.GetMistake();
}

template <int D>
std::string ReadStream(
  vtkUnstructuredGrid* grid, carving::StoredStream<D>& stream, carving::Profile& profile)
{
  const std::string mistake = ReadParts(grid, stream, profile);
  return mistake.empty() ? mistake
                         : "The input is not the stored stream of a carving: " + mistake +
      " The stream of a carver (its output port 1) is needed, as it came out.";
}

template std::string ReadStream<2>(
  vtkUnstructuredGrid*, carving::StoredStream<2>&, carving::Profile&);
template std::string ReadStream<3>(
  vtkUnstructuredGrid*, carving::StoredStream<3>&, carving::Profile&);
