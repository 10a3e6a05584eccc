// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes VTK's arrays of cells.
 */
#ifndef CellArrays_h
#define CellArrays_h

#include "Convert/ArrayTools.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkType.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

template <class Array, std::size_t M, std::size_t N>
void SetCells(const std::vector<std::array<int, M>>& cells,
  const std::vector<std::array<int, N>>& others, vtkCellArray* output)
{
  using Value = typename Array::ValueType;
  vtkNew<Array> connectivity, offsets;
  SetSize<Array>(connectivity, static_cast<vtkIdType>(M * cells.size() + N * others.size()));
  SetSize<Array>(offsets, static_cast<vtkIdType>(cells.size() + others.size() + 1));
  Value* const begin = connectivity->GetPointer(0);
  Value* to = begin;
  Value* offset = offsets->GetPointer(0);
  const auto append = [&](const auto& corners)
  {
    *offset++ = static_cast<Value>(to - begin);
    to = std::copy(corners.begin(), corners.end(), to);
  };
  std::for_each(cells.begin(), cells.end(), append);
  std::for_each(others.begin(), others.end(), append);
  *offset = static_cast<Value>(to - begin);
  output->SetData(offsets, connectivity);
}

/**
 * Fills an array with cells, then with others. Where 32 bits suffice, the array has 32 bits per
 * number and takes half as much memory.
 */
template <std::size_t M, std::size_t N = M>
void FillCellArray(const std::vector<std::array<int, M>>& cells, vtkCellArray* output,
  const std::vector<std::array<int, N>>& others = {})
{
  if (M * cells.size() + N * others.size() <= static_cast<std::size_t>(VTK_TYPE_INT32_MAX))
  {
    SetCells<vtkTypeInt32Array>(cells, others, output);
  }
  else
  {
    SetCells<vtkTypeInt64Array>(cells, others, output);
  }
}

#endif
