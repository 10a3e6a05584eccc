// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExitCode_h
#define ExitCode_h

#include <iostream>
#include <string>

/** The exit codes of `carve`, which its manual page explains. */
namespace ExitCode
{

constexpr int Success = 0;
constexpr int Failure = 1;
constexpr int WrongUsage = 2;

/** Prints an error and returns the exit code. */
inline int Fail(const std::string& error, int exitCode = Failure)
{
  std::cerr << "carve: " << error << "\n";
  return exitCode;
}

} // namespace ExitCode

#endif
