// SPDX-License-Identifier: BSD-3-Clause
#include "Convert/InitialDistance.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>

template <int D>
std::vector<double> ComputeInitialDistances(const carving::Decomposition<D>& mesh)
{
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  if (numberOfCells == 0)
  {
    return {}; // the locator reports an error if there are no faces
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> faces;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      if (mesh.Neighbors[cell][f] < 0)
      {
        faces->InsertNextCell(D);
        for (const int corner : mesh.OutwardFace(cell, f))
        {
          faces->InsertCellPoint(points->InsertNextPoint(mesh.Surface.Points[corner].data()));
        }
      }
    }
  }
  vtkNew<vtkPolyData> initial;
  initial->SetPoints(points);
  if (D == 3)
  {
    initial->SetPolys(faces);
  }
  else
  {
    initial->SetLines(faces);
  }
  // FacetTree of the core would round otherwise, which changes depths in their last digits.
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(initial);
  locator->BuildLocator();

  const double smallest = 1e-9 * carving::Diagonal(mesh.Surface.Points);
  std::vector<double> distances(mesh.Cells.size());
  vtkNew<vtkGenericCell> workspace;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    const carving::Point centroid = mesh.Centroid(cell);
    double closest[3], squared = 0.0;
    vtkIdType cellId;
    int subId;
    locator->FindClosestPoint(centroid.data(), closest, workspace, cellId, subId, squared);
    distances[cell] = std::max(smallest, std::sqrt(squared));
  }
  return distances;
}

template std::vector<double> ComputeInitialDistances<2>(const carving::Decomposition<2>&);
template std::vector<double> ComputeInitialDistances<3>(const carving::Decomposition<3>&);
