// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Contours, and what the tests of vtkContourCarver look at in levels.
 */
#ifndef ContourTesting_h
#define ContourTesting_h

#include "Core/Mesh/Mesh.h"
#include "vtkContourCarver.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <set>
#include <utility>
#include <vector>

using Loop = std::vector<carving::Point>;

void Carve(vtkContourCarver* carver, vtkPolyData* input);
vtkPolyData* LastLevel(vtkContourCarver* carver);
int FieldValue(vtkPolyData* level, const char* name);

/** Each loop a polygon, or a polyline that ends where it ends. */
vtkSmartPointer<vtkPolyData> Polygons(const std::vector<Loop>& loops);
vtkSmartPointer<vtkPolyData> Polylines(const std::vector<Loop>& loops);

Loop Rectangle(double x0, double y0, double x1, double y1);
Loop Reversed(Loop loop);
/** A U of eight corners, counter-clockwise, whose gap is one unit square: area 5. */
Loop LetterU();
/** A star with long and short rays, no two alike, around the origin. */
Loop Star();

/** The directed edges of lines and of the boundaries of polygons, by coordinates. */
std::multiset<std::pair<carving::Point, carving::Point>> Edges(vtkPolyData* contours);
/** What the edges enclose in the plane of x and y, where they run counter-clockwise. */
double Area(vtkPolyData* contours);
/** Of every point that lines use, how many end and how many begin there. */
std::vector<std::pair<int, int>> Degrees(vtkPolyData* contours);

#endif
