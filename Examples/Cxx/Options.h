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
  std::string Output;      ///< empty: none
  std::string Stream;      ///< where to write the stored stream; empty: nowhere
  std::string Profile;     ///< where to write the profile, .csv or .png; empty: nowhere
  std::string InitialMesh; ///< for CUSTOM
  /** The first option that only carving can follow; empty if there is none. */
  std::string CarvingOption;
  bool Contours = false; ///< the input is contours in a plane
  bool ComputeError = false;
  int NumberOfLevels = 8;
  std::vector<double> Targets;
  int TargetType = 0; ///< vtkTopologyCarver::LevelTargets
  // As the filter's properties of the same names.
  int InitialApproximation = 0;
  int PriorityMeasure = 0;
  double DepthExponent = 0.0;
  int DepthMeasure = 0;
  double BreadthRadius = 0.0;
  bool CarveExposed = true;
  bool CarveVoids = true;
  int MaximumComponents = -1;
  int MaximumTunnels = -1;
  int MaximumVoids = -1;
  int KeepBothFoldSides = 2;
  bool ManifoldOutput = true;
  int SolidRule = 0;
  int Conformity = 2;
  double EnclosingTolerance = 0.02;
  double SnapTolerance = 0.0;
  bool AppendInput = false;
  double TimeLimit = 0.0;
  double MemoryLimit = 0.0;
};

/** Returns an empty string or what is wrong with the command line, in one line. */
std::string Parse(int argc, char* argv[], Options& options);

/** Whether a file is, by its name, a stored stream. */
bool IsStream(const std::string& fileName);

/** The manual page. */
extern const char* const HelpText;

#endif
