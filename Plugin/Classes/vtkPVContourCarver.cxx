// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVContourCarver.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVContourCarver);

//------------------------------------------------------------------------------
vtkPVContourCarver::vtkPVContourCarver()
  : vtkPVCarver(2)
{
}
