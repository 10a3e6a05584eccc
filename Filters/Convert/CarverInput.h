// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From vtkPolyData to the core's triangles.
 */
#ifndef CarverInput_h
#define CarverInput_h

#include "Core/Mesh/Mesh.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;

struct CarverInput
{
  carving::TriangleMesh Mesh;
  /** Per triangle of Mesh: the cell of the vtkPolyData that it comes from. */
  std::vector<vtkIdType> CellIds;
  /** For the user: what was passed over or cut in an unusual way. */
  std::vector<std::string> Notes;

  /**
   * Triangulates polygons and strips; passes over vertices, lines, and ghost and hidden cells.
   * Returns an empty string, or an error of CheckCells.
   */
  std::string Gather(vtkPolyData* input);
  bool IsEmpty() const
  {
    return this->Mesh.Triangles.empty();
  }
};

#endif
