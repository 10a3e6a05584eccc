// SPDX-License-Identifier: BSD-3-Clause
#ifndef ErrorLog_h
#define ErrorLog_h

#include "vtkOutputWindow.h"

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

/** Collects the messages of VTK as single lines, without file names and addresses. */
class ErrorLog : public vtkOutputWindow
{
public:
  static ErrorLog* New();
  vtkTypeMacro(ErrorLog, vtkOutputWindow);

  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;

  /** The first error that has followed a number of earlier ones, or an empty string. */
  std::string GetErrorSince(std::size_t errorsBefore) const;

  // Threads may write files beside each other. Nobody reads these lists meanwhile.
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

private:
  void AddWarning(const char* text);
  std::mutex Mutex;
};

#endif
