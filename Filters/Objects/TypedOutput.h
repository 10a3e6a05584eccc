// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Output ports whose type of data follows the input's.
 */
#ifndef TypedOutput_h
#define TypedOutput_h

#include "vtkDataObjectAlgorithm.h"

/**
 * Gives access to a static function that VTK reserves for subclasses. Its last argument must be
 * true: else VTK 9.1 takes a multiblock for an unstructured grid.
 */
class TypedOutput : public vtkDataObjectAlgorithm
{
public:
  using vtkDataObjectAlgorithm::SetOutputDataObject;
};

#endif
