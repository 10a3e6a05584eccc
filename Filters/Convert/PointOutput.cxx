// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/PointOutput.h"

#include "Convert/ArrayNames.h"
#include "Convert/ArrayTools.h"
#include "Convert/CarverInput.h"
#include "Convert/ContourInput.h"
#include "Core/Mesh/FacetTree.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTriangle.h"

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace
{

/** The facets of an input that can be carved, in the order of its coordinates. */
template <int D>
carving::ResolvedInput<D> FacetsOf(vtkPolyData* input)
{
  carving::ResolvedInput<D> facets;
  if constexpr (D == 3)
  {
    CarverInput triangles;
    triangles.Gather(input);
    facets.Points = std::move(triangles.Mesh.Points);
    facets.Facets = std::move(triangles.Mesh.Triangles);
  }
  else
  {
    ContourInput edges;
    edges.Gather(input);
    facets.Points = std::move(edges.Contours.Points);
    facets.Facets = std::move(edges.Contours.Edges);
    edges.Restore(facets.Points);
  }
  return facets;
}

/** Gives new points the data of the closest point of the input. */
template <int D>
void InterpolateNewPoints(
  const carving::ResolvedInput<D>& points, vtkPolyData* input, vtkPointData* output)
{
  std::vector<vtkIdType> made;
  for (std::size_t i = 0; i < points.Points.size(); ++i)
  {
    if (points.PointSources[i] < 0)
    {
      made.push_back(static_cast<vtkIdType>(i));
    }
  }
  const carving::ResolvedInput<D> facets = FacetsOf<D>(input);
  const carving::FacetTree<D> tree(facets);
  std::vector<int> closest(made.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(made.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        closest[i] = tree.Find(points.Points[made[i]]).Item;
      }
    });
  vtkNew<std::conditional_t<D == 3, vtkTriangle, vtkLine>> cell;
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    if (closest[i] < 0)
    {
      continue; // all cells are degenerate
    }
    for (int k = 0; k < D; ++k)
    {
      const int corner = facets.Facets[closest[i]][k];
      cell->GetPointIds()->SetId(k, corner);
      cell->GetPoints()->SetPoint(k, facets.Points[corner].data());
    }
    // The weights of a point that is not on the cell would be those of an extrapolation.
    double onCell[3], again[3], parametric[3], distance, weights[D];
    int subId = 0;
    cell->EvaluatePosition(
      points.Points[made[i]].data(), onCell, subId, parametric, distance, weights);
    cell->EvaluatePosition(onCell, again, subId, parametric, distance, weights);
    output->InterpolatePoint(input->GetPointData(), made[i], cell->GetPointIds(), weights);
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
