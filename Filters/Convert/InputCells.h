// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The visible cells of a vtkPolyData: neither ghosts nor hidden cells.
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

/**
 * Calls `visit(id, number of corners, corners)` for the visible cells in the `wanted` arrays of the
 * input.
 */
template <class Visit>
void VisitCells(vtkPolyData* input, std::initializer_list<vtkCellArray*> wanted, const Visit& visit)
{
  vtkUnsignedCharArray* ghosts = input->GetCellGhostArray();
  if (ghosts && ghosts->GetNumberOfTuples() != input->GetNumberOfCells())
  {
    ghosts = nullptr; // arrays of a wrong length are left out
  }
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
 * Returns an empty string, or the reason why these cells cannot be carved: their number exceeds
 * 32-bit integers, their arrays contradict each other, a cell has a point that does not exist, a
 * coordinate is not finite, or products of coordinates are not finite.
 */
std::string CheckCells(vtkPolyData* input, std::initializer_list<vtkCellArray*> cells);

#endif
