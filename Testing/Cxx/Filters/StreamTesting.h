// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Functions that the tests of damaged streams share.
 */
#ifndef StreamTesting_h
#define StreamTesting_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>

/** A stream of a mesh, or of contours, with all possible arrays. */
vtkSmartPointer<vtkUnstructuredGrid> MakeStream(bool plane = false);

/** The error that every way to ask for a level gives, with an empty level; "" if there is none. */
std::string ErrorOf(vtkUnstructuredGrid* stream);

/** Expects that the stream is refused with an error that contains this text. */
void ExpectError(vtkUnstructuredGrid* stream, const std::string& text);

#endif
