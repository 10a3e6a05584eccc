// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContourCarver.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkContourCarver);

//------------------------------------------------------------------------------
vtkContourCarver::vtkContourCarver()
  : vtkCarverAlgorithm(2)
{
}

//------------------------------------------------------------------------------
vtkContourCarver::~vtkContourCarver() = default;
