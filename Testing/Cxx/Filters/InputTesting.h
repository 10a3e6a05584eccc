// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions that the tests of kinds of input share.
 */
#ifndef InputTesting_h
#define InputTesting_h

#include "FilterTesting.h"

#include <functional>
#include <vector>

using Polygons = std::vector<std::vector<vtkIdType>>;
vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<carving::Point>& points, const Polygons& polygons);

/** Boxes one unit apart in x, as quadrilaterals, with all points moved. */
vtkSmartPointer<vtkPolyData> QuadBoxes(
  const std::function<carving::Point(const carving::Point&)>& move);
inline vtkSmartPointer<vtkPolyData> QuadBoxes()
{
  return QuadBoxes([](const carving::Point& p) { return p; });
}

/** The volume that a closed surface of triangles encloses. */
double GetVolume(vtkPolyData* level);

#endif
