// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVContourCarver
 * @brief vtkContourCarver for ParaView, with a port 0 that shows one level
 */
#ifndef vtkPVContourCarver_h
#define vtkPVContourCarver_h

#include "vtkPVCarver.h"

class VTKTOPOLOGYCARVINGPARAVIEW_EXPORT vtkPVContourCarver : public vtkPVCarver
{
public:
  static vtkPVContourCarver* New();
  vtkTypeMacro(vtkPVContourCarver, vtkPVCarver);

protected:
  vtkPVContourCarver();
  ~vtkPVContourCarver() override = default;

private:
  vtkPVContourCarver(const vtkPVContourCarver&) = delete;
  void operator=(const vtkPVContourCarver&) = delete;
};

#endif
