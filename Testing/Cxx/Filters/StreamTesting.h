// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the tests of damaged streams share.
 */
#ifndef StreamTesting_h
#define StreamTesting_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>

/** A stream of a mesh, or of contours, with all arrays that there may be. */
vtkSmartPointer<vtkUnstructuredGrid> MakeStream(bool plane = false);

/** The one error of all ways to ask for a level, after which that is empty; "" if there is none. */
std::string ErrorOf(vtkUnstructuredGrid* stream);

/** The stream is refused in an error that has this text. */
void ExpectError(vtkUnstructuredGrid* stream, const std::string& text);

#endif
