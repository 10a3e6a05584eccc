// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Contours for the tests of vtkContourCarver, and properties of levels that the tests compare.
 */
#ifndef ContourTesting_h
#define ContourTesting_h

#include "Core/Mesh/Mesh.h"
#include "FilterTesting.h"
#include "vtkContourCarver.h"

#include <utility>

using Loop = std::vector<carving::Point>;

/** Each loop becomes a polygon, or a polyline from its first to its last point. */
vtkSmartPointer<vtkPolyData> MakePolygons(const std::vector<Loop>& loops);
vtkSmartPointer<vtkPolyData> Polylines(const std::vector<Loop>& loops);

Loop Rectangle(double x0, double y0, double x1, double y1);
Loop Reversed(Loop loop);
/** A U of eight corners, counter-clockwise, whose gap is one unit square: area 5. */
Loop LetterU();
/** A star with long and short rays, no two alike, around the origin. */
Loop Star();

/** The directed edges of lines and of the boundaries of polygons, by coordinates. */
std::multiset<std::pair<carving::Point, carving::Point>> Edges(vtkPolyData* contours);
/** The area that counter-clockwise edges enclose in the plane of x and y. */
double Area(vtkPolyData* contours);
/** For every point of lines, the numbers of lines that end and that begin there. */
std::vector<std::pair<int, int>> Degrees(vtkPolyData* contours);

#endif
