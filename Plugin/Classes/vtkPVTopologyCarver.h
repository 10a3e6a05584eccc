// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVTopologyCarver
 * @brief vtkTopologyCarver for ParaView, with a port 0 that shows one level
 */
#ifndef vtkPVTopologyCarver_h
#define vtkPVTopologyCarver_h

#include "vtkPVCarver.h"

class VTKTOPOLOGYCARVINGPARAVIEW_EXPORT vtkPVTopologyCarver : public vtkPVCarver
{
public:
  static vtkPVTopologyCarver* New();
  vtkTypeMacro(vtkPVTopologyCarver, vtkPVCarver);

protected:
  vtkPVTopologyCarver();
  ~vtkPVTopologyCarver() override = default;

private:
  vtkPVTopologyCarver(const vtkPVTopologyCarver&) = delete;
  void operator=(const vtkPVTopologyCarver&) = delete;
};

#endif
