// SPDX-License-Identifier: BSD-3-Clause
#ifndef Report_h
#define Report_h

#include "StageClock.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

class ErrorLog;
struct Options;

/** What a run has computed, and what is to be said about it. */
struct Report
{
  vtkSmartPointer<vtkMultiBlockDataSet> Levels;
  vtkSmartPointer<vtkUnstructuredGrid> Stream; ///< of a carving; null if there are several
  vtkSmartPointer<vtkTable> Profile;           ///< null if there is none
  StageClock Clock;
  std::vector<std::string> Files; ///< that have been written
  std::vector<std::string> Warnings;
  std::vector<std::string> Errors; ///< of those inputs that have no levels
};

/**
 * Writes the files that the options ask for, and prints the table or the JSON. `log` has the
 * messages so far. Returns the exit code.
 */
int Finish(const Options& options, ErrorLog* log, Report& report);

#endif
