// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From vtkPolyData to the edges of the core, in the plane of the first two coordinates.
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
   * The edges. Coordinates are permuted: the last axis is the one closest to the plane's normal.
   */
  carving::ContourSet Contours;
  /** For each edge of Contours, its cell of the vtkPolyData. */
  std::vector<vtkIdType> CellIds;
  /** Sentences for the user on cells that were ignored. */
  std::vector<std::string> Notes;

  /**
   * Takes the edges of polylines and of the boundaries of polygons. Ignores vertices, strips, and
   * ghost and hidden cells. Returns an empty string, or an error: one of CheckCells, or a point of
   * an edge that is not in the plane of the other points.
   */
  std::string Gather(vtkPolyData* input);
  /** The same for edges that must lie in the plane of another input, if that has any edges. */
  std::string GatherInPlaneOf(const ContourInput& other, vtkPolyData* input);
  bool IsEmpty() const
  {
    return this->Contours.Edges.empty();
  }

  /** Restores the order of coordinates that the vtkPolyData has. */
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
  /** Finds the plane unless it is known. Returns an error if a point is too far from the plane. */
  std::string CheckPlane();
  /** Moves the axis closest to the plane's normal to the last place. */
  void PermuteAxes();

  Plane Common;
  int Axis = 2; ///< the axis closest to the normal
};

#endif
