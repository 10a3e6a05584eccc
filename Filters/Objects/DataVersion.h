// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of a data object at some time.
 */
#ifndef DataVersion_h
#define DataVersion_h

#include "vtkDataObject.h"
#include "vtkWeakPointer.h"

/**
 * Identifies a data object and its state without keeping the object alive. A time stamp alone does
 * not identify an object: two objects that share their points have the same stamp if the points are
 * the newest part of both.
 */
class DataVersion
{
public:
  /** The version of no data. */
  DataVersion() = default;
  /** Null stands for no data. */
  explicit DataVersion(vtkDataObject* data)
    : Object(data)
    , Time(data ? data->GetMTime() : 0)
  {
  }

  /** Whether this is the version of `data`, which can be null, in its present state. */
  bool IsOf(vtkDataObject* data) const
  {
    return this->Object == data && this->Time == (data ? data->GetMTime() : 0);
  }

  /** Whether the object still exists in this state. */
  bool IsCurrent() const
  {
    return this->Object && this->IsOf(this->Object);
  }

private:
  vtkWeakPointer<vtkDataObject> Object;
  vtkMTimeType Time = 0; ///< 0 for no data, not for data that has been deleted since
};

#endif
