// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/StreamInput.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayReader.h"
#include "Convert/ProfileInput.h"
#include "Convert/SimplifiedOutput.h"
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

namespace
{

std::string Number(vtkIdType number)
{
  return std::to_string(number);
}

/** Returns an empty string, or a description of the mistake. */
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

/** Appends a cell or a facet. Returns false if the number of corners is wrong. */
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

/** Whether the arrays that cells are read from are consistent. */
bool AreCellsValid(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  return types->GetNumberOfComponents() == 1 &&
    types->GetNumberOfValues() == grid->GetNumberOfCells() && grid->GetCells()->IsValid();
}

/**
 * The cells of the complement, then the facets of M. Returns an empty string, or a description of
 * the mistake.
 */
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
      return "cell " + Number(i) + " is not a cell of a stream.";
    }
  }
  return {};
}

/** Reads the arrays of cells, facets and points. The facets follow the cells. */
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
  reader.Check(cellData, StreamArrays::Priority, count,
    Priorities([&](vtkIdType i) { return i < cells && order.Step[i] > 0; }));
  reader.Check(cellData, StreamArrays::Depth, count, FiniteMeasures());
  reader.Check(cellData, StreamArrays::Region, count, IntegersFrom(-1));
  reader.Read(cellData, StreamArrays::SolidSides, count, IntegersFrom(0, 3), solidSides);
  reader.Read(grid->GetPointData(), StreamArrays::OriginalPoints, grid->GetNumberOfPoints(),
    IntegersFrom(-1), stream.Mesh.Surface.PointSources);
}

/** Checks the arrays that levels get unchanged. */
void CheckPassedOn(vtkUnstructuredGrid* grid, ArrayReader& reader)
{
  vtkPointData* pointData = grid->GetPointData();
  vtkCellData* cellData = grid->GetCellData();
  vtkFieldData* fieldData = grid->GetFieldData();
  reader.Check(cellData, StreamArrays::OriginalCells, grid->GetNumberOfCells(), IntegersFrom(-1));
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
  checkIfThere(fieldData, StreamArrays::KeptDistance99, 1);
  checkIfThere(fieldData, StreamArrays::KeptDistanceMean, 1);
  checkIfThere(fieldData, StreamArrays::MetShare, 1);
  checkIfThere(fieldData, StreamArrays::SnapDistance, 1);
  if (fieldData->HasArray(StreamArrays::SnapDistance)) // else the input itself has such point data
  {
    checkIfThere(pointData, StreamArrays::SnapDistance, grid->GetNumberOfPoints());
  }
}

/** Keeps the part of a cell array that belongs to the cells (`first` 0) or to the facets. */
template <class Value>
void TakePart(std::vector<Value>& values, std::size_t first, std::size_t count)
{
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
  values.resize(count);
}

/** Reads all arrays. Returns an empty string, or a description of the first mistake. */
template <int D>
std::string ReadArrays(vtkUnstructuredGrid* grid, carving::StoredStream<D>& stream,
  carving::Profile& profile, carving::SimplifiedStream& simplified)
{
  ArrayReader reader;
  std::vector<int> both, solidSides;
  reader.Read(grid->GetFieldData(), StreamArrays::BothFoldSides, 1, IntegersFrom(0, 1), both);
  stream.Measure = ReadProfile(grid, reader, profile);
  ReadOrder(grid, profile.LastStep(), reader, stream, solidSides);
  CheckPassedOn(grid, reader);
  if (D == 3)
  {
    ReadSimplifiedStream(grid, profile, reader, simplified);
  }
  if (!reader.GetMistake().empty())
  {
    return reader.GetMistake();
  }
  const std::size_t cells = stream.Mesh.Cells.size();
  const std::size_t facets = stream.Mesh.Surface.Facets.size();
  TakePart(stream.Order.Step, 0, cells);
  TakePart(solidSides, cells, facets);
  for (int& step : stream.Order.Step)
  {
    step = step < 0 ? carving::Stream::Never : step;
  }
  stream.Folds = both[0] != 0 ? carving::FoldSides::Both : carving::FoldSides::One;
  stream.Order.StepPriority = profile.Priority;
  return carving::Connect(stream, solidSides) ? "" : "its cells do not fit together.";
}

/**
 * Compares the counts of the profile with the cells. Returns an empty string, or the first mistake.
 */
template <int D>
std::string CheckCounts(const carving::StoredStream<D>& stream, const carving::Profile& profile)
{
  ArrayReader reader;
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

/** Returns an empty string, or a description of the first mistake. */
template <int D>
std::string ReadParts(vtkUnstructuredGrid* grid, carving::StoredStream<D>& stream,
  carving::Profile& profile, carving::SimplifiedStream& simplified)
{
  // The faces of cells are numbered, too.
  if (grid->GetNumberOfPoints() > VTK_INT_MAX || grid->GetNumberOfCells() > VTK_INT_MAX / (D + 1))
  {
    return "it has more points or cells than a 32-bit integer can count.";
  }
  std::string mistake = ReadPoints(grid, stream.Mesh.Surface.Points);
  mistake = mistake.empty() ? ReadCells(grid, stream.Mesh) : mistake;
  mistake = mistake.empty() ? ReadArrays(grid, stream, profile, simplified) : mistake;
  return mistake.empty() ? CheckCounts(stream, profile) : mistake;
}

} // namespace

template <int D>
std::string ReadStream(vtkUnstructuredGrid* grid, carving::StoredStream<D>& stream,
  carving::Profile& profile, carving::SimplifiedStream& simplified)
{
  const std::string mistake = ReadParts(grid, stream, profile, simplified);
  return mistake.empty() ? mistake
                         : "The input is not the stored stream of a carving: " + mistake +
      " The input must be the unchanged output of a carver on its port 1.";
}

template std::string ReadStream<2>(
  vtkUnstructuredGrid*, carving::StoredStream<2>&, carving::Profile&, carving::SimplifiedStream&);
template std::string ReadStream<3>(
  vtkUnstructuredGrid*, carving::StoredStream<3>&, carving::Profile&, carving::SimplifiedStream&);
