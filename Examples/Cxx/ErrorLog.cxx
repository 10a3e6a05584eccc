// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorLog.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(ErrorLog);

namespace
{

/** From "ERROR: In FILE, line N\nvtkClass (0xADDRESS): message\n\n" to "message". */
std::string ExtractMessage(std::string text)
{
  const std::size_t address = text.find(" (0x");
  const std::size_t message = text.find("): ", address);
  if (address != std::string::npos && message != std::string::npos)
  {
    text.erase(0, message + 3);
  }
  text.erase(text.find_last_not_of("\n ") + 1);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/** Whether a message tells a user nothing. */
bool MeansNothing(const std::string& message)
{
  // The pipeline repeats each error of a filter.
  const bool isRepeated = message.find("returned failure for request") != std::string::npos;
  // VTK's XML files keep the range of lengths of vectors. Its readers cannot read infinite ones,
  // but read the vectors, and need no range.
  const bool isOfRange =
    message.find("InformationKey element for vtkDataArray::L2_NORM_RANGE") != std::string::npos;
  return isRepeated || isOfRange;
}

} // namespace

void ErrorLog::DisplayErrorText(const char* text)
{
  const std::string message = ExtractMessage(text);
  if (!MeansNothing(message))
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Errors.push_back(message);
  }
}

void ErrorLog::DisplayWarningText(const char* text)
{
  this->AddWarning(text);
}

void ErrorLog::DisplayGenericWarningText(const char* text)
{
  this->AddWarning(text);
}

std::string ErrorLog::GetErrorSince(std::size_t errorsBefore) const
{
  return this->Errors.size() > errorsBefore ? this->Errors[errorsBefore] : "";
}

void ErrorLog::AddWarning(const char* text)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Warnings.push_back(ExtractMessage(text));
}
