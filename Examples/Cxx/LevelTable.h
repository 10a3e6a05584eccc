// SPDX-License-Identifier: BSD-3-Clause
#ifndef LevelTable_h
#define LevelTable_h

class vtkMultiBlockDataSet;
class vtkUnstructuredGrid;

/** Prints the levels of one input to standard output. */
namespace LevelTable
{

/** Steps, sizes and topology of levels. */
void PrintLevels(vtkMultiBlockDataSet* levels, bool contours);

/** The number of tetrahedra (in the plane, triangles) of a stream, and the strategy that made them. */
void PrintStream(vtkUnstructuredGrid* stream, bool contours);

/** Sizes and errors of decimated surfaces. */
void PrintSurfaces(vtkMultiBlockDataSet* surfaces);

void PrintNotes(vtkMultiBlockDataSet* levels);

} // namespace LevelTable

#endif
