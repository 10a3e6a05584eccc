// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include <map>
#include <string>
#include <vector>

/** The contents of the command line of `carve`. */
struct Options
{
  enum class Action
  {
    Carve,
    ShowHelp,
    ShowVersion
  };

  Action Wanted = Action::Carve;
  std::vector<std::string> Inputs; ///< several: a scene, with a block for each
  std::string Output;              ///< empty: none
  std::string Stream;              ///< the file for the stored stream; empty: none
  std::string Profile;             ///< the file for the profile, .csv or .png; empty: none
  std::string InitialMesh;         ///< for CUSTOM
  /**
   * The last option that applies to carving only, not to a stored stream; empty if there is none.
   */
  std::string CarvingOption;
  bool Contours = false; ///< the input is contours in a plane
  bool Decimate = false; ///< decimate the input instead of carving it
  bool Nested = false;   ///< for Decimate
  int NumberOfLevels = 8;
  std::vector<double> Targets;
  int TargetType = 0;         ///< vtkTopologyCarver::LevelTargets
  bool ManifoldOutput = true; ///< also in Properties

  bool IsScene() const
  {
    return this->Inputs.size() > 1;
  }

  /** The given values of properties of vtkCarverAlgorithm, by name. */
  std::map<std::string, double> Properties;
};

/** Returns an empty string, or a line that describes the mistake in the command line. */
std::string Parse(int argc, char* argv[], Options& options);

/** Whether a file is, by its name, a stored stream. */
bool IsStream(const std::string& fileName);

#endif
