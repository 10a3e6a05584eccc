// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The setter of a property that is a number.
 */
#ifndef SetNumber_h
#define SetNumber_h

#include "vtkObject.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>

/**
 * Sets a property to the number from 0 to `greatest` that is closest to `number`. A number that is
 * not finite is refused with an error, unlike by the macros of VTK.
 */
inline void SetNumber(
  vtkObject* object, const char* name, double number, double greatest, double& property)
{
  if (!std::isfinite(number))
  {
    vtkErrorWithObjectMacro(
      object, << name << " cannot be " << number << ": it stays " << property << ".");
    return;
  }
  const double clamped = std::clamp(number, 0.0, greatest);
  if (clamped != property)
  {
    property = clamped;
    object->Modified();
  }
}

#endif
