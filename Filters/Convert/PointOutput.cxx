// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/PointOutput.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayTools.h"
#include "vtkCellLocator.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <vector>

namespace
{

/** Gives new points the data of the closest point of the input. */
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
  locator->SetNumberOfCellsPerBucket(4);
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

} // namespace

template <int D>
void FillPoints(const carving::ResolvedInput<D>& points, vtkPolyData* input, vtkPointSet* output)
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

template void FillPoints<2>(const carving::ResolvedInput<2>&, vtkPolyData*, vtkPointSet*);
template void FillPoints<3>(const carving::ResolvedInput<3>&, vtkPolyData*, vtkPointSet*);
