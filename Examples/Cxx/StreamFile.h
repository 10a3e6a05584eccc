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

/** Returns an empty string or why the file could not be read. */
std::string Read(const std::string& fileName, ErrorLog* log, vtkUnstructuredGrid* stream);

/** The profile that a stream carries; empty if it has none. */
void GetProfile(vtkUnstructuredGrid* stream, vtkTable* profile);

/** The levels that the options ask for, coarse to fine; errors and warnings come from the filter. */
void Extract(const Options& options, vtkUnstructuredGrid* stream, vtkMultiBlockDataSet* levels);

} // namespace StreamFile

#endif
