// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From vtkPolyData to the core's edges in the plane of the first two coordinates.
 */
#ifndef ContourInput_h
#define ContourInput_h

#include "Core/Mesh/Mesh.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;

struct ContourInput
{
  /**
   * The coordinates have been rotated: the last axis is the one closest to the plane's normal.
   */
  carving::ContourSet Contours;
  /** Per edge of Contours: the cell of the vtkPolyData that it comes from. */
  std::vector<vtkIdType> CellIds;
  /** For the user: what was passed over. */
  std::vector<std::string> Notes;

  /**
   * Takes the edges of polylines and of the boundaries of polygons; passes over vertices, strips, and
   * ghost and hidden cells. Returns an empty string, or an error: one of CheckCells, or a point of an
   * edge that is not in the plane of the others.
   */
  std::string Gather(vtkPolyData* input);
  /** The same for edges that have to lie in the plane of those of another input, if that has any. */
  std::string GatherInPlaneOf(const ContourInput& other, vtkPolyData* input);
  bool IsEmpty() const
  {
    return this->Contours.Edges.empty();
  }

  /** Rotates the coordinates of points back to those of the vtkPolyData. */
  void Restore(std::vector<carving::Point>& points) const;

private:
  struct Plane
  {
    bool Known = false;
    carving::Point Origin = { 0.0, 0.0, 0.0 };
    carving::Point Normal = { 0.0, 0.0, 1.0 };
    double Tolerance = 0.0;
  };

  std::string GatherEdges(vtkPolyData* input);
  std::string Rotate();

  Plane Common;
  int Axis = 2; ///< closest to the normal
};

#endif
