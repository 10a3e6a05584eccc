// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which data object, in which state.
 */
#ifndef DataVersion_h
#define DataVersion_h

#include "vtkDataObject.h"
#include "vtkWeakPointer.h"

/**
 * Remembers the state of a data object without keeping the object alive. A time stamp alone does not tell
 * objects apart: two that share their points have the same one if the points are the newest part of both.
 */
class DataVersion
{
public:
  DataVersion() = default;
  /** Null stands for no data. */
  explicit DataVersion(vtkDataObject* data)
    : Object(data)
    , Time(data ? data->GetMTime() : 0)
  {
  }

  /** Whether this is that object, and it has not changed since. */
  bool IsOf(vtkDataObject* data) const
  {
    return this->Object == data && this->Time == (data ? data->GetMTime() : 0);
  }

private:
  vtkWeakPointer<vtkDataObject> Object;
  vtkMTimeType Time = 0; ///< 0: no data, unlike data that has been deleted since
};

#endif
