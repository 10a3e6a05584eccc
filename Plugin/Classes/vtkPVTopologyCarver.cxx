// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTopologyCarver.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVTopologyCarver);

//------------------------------------------------------------------------------
vtkPVTopologyCarver::vtkPVTopologyCarver()
  : vtkPVCarver(3)
{
}
