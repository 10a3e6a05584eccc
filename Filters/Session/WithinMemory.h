// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Memory that runs out is an error of the filter, not the end of the program.
 */
#ifndef WithinMemory_h
#define WithinMemory_h

#include "vtkAlgorithm.h"

#include <new>
#include <string>

constexpr const char* OutOfMemory =
  "There is not enough memory for the result. Use a smaller mesh, "
  "or a machine with more memory.";

/**
 * Whether `work` succeeds. If memory runs out, that is an error of the filter, whose message
 * `where` begins, and not a success.
 */
template <class Work>
bool WithinMemory(vtkAlgorithm* filter, const std::string& where, Work&& work)
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(filter, << where << OutOfMemory);
    return false;
  }
}

#endif
