// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From vtkPolyData to the triangles of the core.
 */
#ifndef CarverInput_h
#define CarverInput_h

#include "Core/Mesh/Mesh.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkCellArray;
class vtkPolyData;

struct CarverInput
{
  carving::TriangleMesh Mesh;
  /** For each triangle of Mesh, its cell of the vtkPolyData. */
  std::vector<vtkIdType> CellIds;
  /** Sentences for the user on cells that were ignored, or cut in an unusual way. */
  std::vector<std::string> Notes;

  /**
   * Triangulates polygons and strips. Ignores vertices, lines, and ghost and hidden cells. Returns
   * an empty string, an error of CheckCells, or NothingToCarve if there are polygons, but no
   * triangles.
   */
  std::string Gather(vtkPolyData* input);
  bool IsEmpty() const
  {
    return this->Mesh.Triangles.empty();
  }

private:
  vtkIdType AddPolygons(vtkPolyData* input);
  vtkIdType AddStrips(vtkPolyData* input);
  void AddTriangles(vtkIdType cell, vtkCellArray* triangles);
};

#endif
