// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/PointOutput.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayTools.h"
#include "vtkCellArray.h"
#include "vtkCellLocator.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <vector>

namespace
{

/** A point of a surface. */
struct Closest
{
  vtkIdType Cell = -1;
  carving::Point At;
};

/** Finds the points of a surface that are closest to some points. */
class ClosestFinder
{
public:
  ClosestFinder(vtkPolyData* surface, const std::vector<vtkIdType>& ids,
    const std::vector<carving::Point>& points, std::vector<Closest>& found)
    : Surface(surface)
    , Ids(ids)
    , Points(points)
    , Found(found)
  {
  }

  void Initialize()
  {
    // Deterministic for equally close cells; the order of vtkStaticCellLocator depends on its
    // threads. Queries use the locator's memory, so that each thread needs its own.
    vtkCellLocator* locator = this->Locators.Local();
    locator->SetDataSet(this->Surface);
    locator->CacheCellBoundsOn();
    locator->SetNumberOfCellsPerBucket(1);
    locator->BuildLocator();
  }
  void operator()(vtkIdType begin, vtkIdType end)
  {
    vtkNew<vtkGenericCell> cell;
    for (vtkIdType i = begin; i < end; ++i)
    {
      double distance;
      int subId = 0;
      this->Locators.Local()->FindClosestPoint(this->Points[this->Ids[i]].data(),
        this->Found[i].At.data(), cell, this->Found[i].Cell, subId, distance);
    }
  }
  void Reduce()
  {
  }

private:
  vtkPolyData* Surface;
  const std::vector<vtkIdType>& Ids;
  const std::vector<carving::Point>& Points;
  std::vector<Closest>& Found;
  vtkSMPThreadLocalObject<vtkCellLocator> Locators;
};

/** Several threads may read cells at once only if they are stored as vtkIdType. */
vtkSmartPointer<vtkCellArray> CopyForThreads(vtkCellArray* cells)
{
  auto copy = vtkSmartPointer<vtkCellArray>::New();
  copy->DeepCopy(cells);
  copy->ConvertToDefaultStorage();
  return copy;
}

std::vector<Closest> FindClosest(vtkPolyData* surface, const std::vector<vtkIdType>& ids,
  const std::vector<carving::Point>& points)
{
  std::vector<Closest> found(ids.size());
  surface->BuildCells(); // before several threads would
  surface->ComputeBounds();
  ClosestFinder finder(surface, ids, points, found);
  vtkSMPTools::For(0, static_cast<vtkIdType>(ids.size()), finder);
  return found;
}

/** Gives new points the data of the closest point of the input. */
template <int D>
void InterpolateNewPoints(
  const carving::ResolvedInput<D>& points, vtkPolyData* input, vtkPointData* output)
{
  vtkNew<vtkPolyData> surface; // without cells that bound nothing: vertices and, in space, lines
  surface->SetPoints(input->GetPoints());
  surface->SetPolys(CopyForThreads(input->GetPolys()));
  surface->SetStrips(CopyForThreads(input->GetStrips()));
  if (D == 2)
  {
    surface->SetLines(CopyForThreads(input->GetLines()));
  }
  std::vector<vtkIdType> made;
  for (std::size_t i = 0; i < points.Points.size(); ++i)
  {
    if (points.PointSources[i] < 0)
    {
      made.push_back(static_cast<vtkIdType>(i));
    }
  }
  const std::vector<Closest> closest = FindClosest(surface, made, points.Points);
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights(std::max(3, surface->GetMaxCellSize()));
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    if (closest[i].Cell < 0)
    {
      continue; // all cells are degenerate
    }
    double onCell[3], parametric[3], distance;
    int subId = 0;
    surface->GetCell(closest[i].Cell, cell);
    cell->EvaluatePosition(
      closest[i].At.data(), onCell, subId, parametric, distance, weights.data());
    output->InterpolatePoint(input->GetPointData(), made[i], cell->GetPointIds(), weights.data());
  }
}

} // namespace

template <int D>
void FillPoints(const carving::ResolvedInput<D>& points, vtkPolyData* input, vtkPointSet* output)
{
  const vtkIdType count = static_cast<vtkIdType>(points.Points.size());
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  SetSize(coordinates->GetData(), count);
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

template void FillPoints<2>(const carving::ResolvedInput<2>&, vtkPolyData*, vtkPointSet*);
template void FillPoints<3>(const carving::ResolvedInput<3>&, vtkPolyData*, vtkPointSet*);
