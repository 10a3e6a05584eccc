// SPDX-License-Identifier: BSD-3-Clause
#ifndef LevelTable_h
#define LevelTable_h

class vtkMultiBlockDataSet;
class vtkUnstructuredGrid;
struct Options;

namespace LevelTable
{

/**
 * Prints the levels of all objects to standard output: steps, sizes and topology, or sizes and
 * errors of decimated surfaces.
 */
void Print(const Options& options, vtkMultiBlockDataSet* output);

/**
 * The number of tetrahedra (in the plane, triangles) of a stream, and the strategy that made them.
 */
void PrintStream(vtkUnstructuredGrid* stream, bool contours);

} // namespace LevelTable

#endif
