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
  std::string Output;              ///< a file, or a folder with a file for each input; empty: none
  std::string Format;              ///< of the files in a folder: ".glb"; empty: not given
  std::string Json;                ///< the file for the table as JSON; "-": standard output
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

  /** Whether every input has a result of its own in the folder Output. */
  bool WritesFolder() const;
  /** The extension of the results, in lower case: ".vtm". */
  std::string GetFormat() const;
  /** The name of the result of an input. */
  std::string GetFile(const std::string& input) const;

  /** Whether levels are simplified. */
  bool Simplifies() const
  {
    return this->Properties.count("LevelSimplification") > 0;
  }

  /** Whether standard output is for JSON alone. */
  bool IsQuiet() const
  {
    return this->Json == "-";
  }

  /** The given values of properties of vtkCarverAlgorithm, by name. */
  std::map<std::string, double> Properties;
};

/** Returns an empty string, or a line that describes the mistake in the command line. */
std::string Parse(int argc, char* argv[], Options& options);

/** Whether a file is, by its name, a stored stream. */
bool IsStream(const std::string& fileName);

#endif
