// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The outputs of a carver.
 */
#ifndef CarverPorts_h
#define CarverPorts_h

#include "vtkMultiBlockDataSet.h"

#include <array>

/** The outputs for a polydata, or for a composite of polydata. */
struct CarverPorts
{
  vtkMultiBlockDataSet* Levels;
  vtkDataObject* Stream;  ///< vtkUnstructuredGrid, or vtkMultiBlockDataSet for a composite
  vtkDataObject* Profile; ///< vtkTable, or vtkMultiBlockDataSet for a composite

  std::array<vtkDataObject*, 3> GetAll() const
  {
    return { this->Levels, this->Stream, this->Profile };
  }
};

#endif
