// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Unstructured grids as damaged or foreign files may have them, drawn from bytes.
 */
#ifndef GridDamage_h
#define GridDamage_h

#include "Bytes.h"

class vtkUnstructuredGrid;

/** Changes one thing: a corner, a type or an offset of a cell, a coordinate, or an array's values or form. */
void Damage(Bytes& bytes, vtkUnstructuredGrid* grid);

/** Any cells of few points, with some arrays that are called like those of a stream. */
void MakeForeign(Bytes& bytes, vtkUnstructuredGrid* grid);

#endif
