// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Unstructured grids as damaged or foreign files may contain them, drawn from bytes.
 */
#ifndef GridDamage_h
#define GridDamage_h

#include "Bytes.h"

class vtkUnstructuredGrid;

/**
 * Makes one change: to a corner, type or offset of a cell, to a coordinate, or to an array's values
 * or form.
 */
void Damage(Bytes& bytes, vtkUnstructuredGrid* grid);

/** Adds random cells of few points, and arrays with the names of a stream's arrays. */
void MakeForeign(Bytes& bytes, vtkUnstructuredGrid* grid);

#endif
