// SPDX-License-Identifier: BSD-3-Clause
#ifndef StreamFile_h
#define StreamFile_h

#include <string>

class ErrorLog;
class vtkMultiBlockDataSet;
class vtkTable;
class vtkUnstructuredGrid;
struct Options;

/** Stored streams as .vtu files. */
namespace StreamFile
{

/** Returns an empty string, or the reason why the file cannot be read. */
std::string Read(const std::string& fileName, ErrorLog* log, vtkUnstructuredGrid* stream);

/** Whether a stream is that of contours. */
bool HoldsContours(vtkUnstructuredGrid* stream);

/**
 * Extracts the levels that the options ask for, from coarse to fine, and the profile. The filter
 * reports errors and warnings.
 */
void Extract(const Options& options, vtkUnstructuredGrid* stream, vtkMultiBlockDataSet* levels,
  vtkTable* profile);

} // namespace StreamFile

#endif
