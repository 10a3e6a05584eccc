// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTopologyCarver.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTopologyCarver);

//------------------------------------------------------------------------------
vtkTopologyCarver::vtkTopologyCarver()
  : vtkCarverAlgorithm(3)
{
}

//------------------------------------------------------------------------------
vtkTopologyCarver::~vtkTopologyCarver() = default;
