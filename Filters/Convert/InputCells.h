// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The cells of a vtkPolyData that are there for the user: neither ghosts nor hidden.
 */
#ifndef InputCells_h
#define InputCells_h

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <initializer_list>
#include <string>

/** Calls `visit(id, number of corners, corners)` for the cells of some of a vtkPolyData's arrays. */
template <class Visit>
void VisitCells(vtkPolyData* input, std::initializer_list<vtkCellArray*> wanted, const Visit& visit)
{
  vtkUnsignedCharArray* ghosts = input->GetCellGhostArray();
  constexpr unsigned char skipped =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  vtkIdType id = 0;
  for (vtkCellArray* cells :
    { input->GetVerts(), input->GetLines(), input->GetPolys(), input->GetStrips() })
  {
    const bool isWanted = std::find(wanted.begin(), wanted.end(), cells) != wanted.end();
    const vtkIdType count = cells->GetNumberOfCells();
    for (vtkIdType i = 0; isWanted && i < count; ++i)
    {
      if (!ghosts || (ghosts->GetValue(id + i) & skipped) == 0)
      {
        vtkIdType size;
        const vtkIdType* corners;
        cells->GetCellAtId(i, size, corners);
        visit(id + i, size, corners);
      }
    }
    id += count;
  }
}

/**
 * Why these cells cannot be carved, or an empty string: more than 32-bit integers count, a cell with a
 * point that there is not, a coordinate that is not finite, or coordinates whose products are not.
 */
std::string CheckCells(vtkPolyData* input, std::initializer_list<vtkCellArray*> cells);

#endif
