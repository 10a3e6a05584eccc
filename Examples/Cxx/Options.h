// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include <string>
#include <vector>

/** What the command line of `carve` asks for. */
struct Options
{
  enum class Action
  {
    Carve,
    ShowHelp,
    ShowVersion
  };

  Action Wanted = Action::Carve;
  std::string Input;
  std::string Output; ///< empty: none
  int NumberOfLevels = 8;
  std::vector<double> Targets;
  bool TargetsAreTriangles = false;
  bool CarveExposed = true;
};

/** Returns an empty string or what is wrong with the command line, in one line. */
std::string Parse(int argc, char* argv[], Options& options);

/** The manual page. */
extern const char* const HelpText;

#endif
