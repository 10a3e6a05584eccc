// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Levels by the pair: carved first, then decimated by edge collapses. Not in the paper, which names
 * both together as future work (section 7).
 */
#ifndef LevelSimplifier_h
#define LevelSimplifier_h

#include "Core/Mesh/FaceDistance.h"
#include "Process/HelperProcess.h"
#include "Session/CarvedLeaf.h"
#include "Session/LevelTrials.h"

#include <optional>
#include <string>
#include <vector>

/** The targets of simplified levels, from coarse to fine. */
std::vector<carving::SimplifiedTarget> MakeSimplifiedTargets(
  const carving::Profile& profile, const CarverSettings& settings);

/**
 * Makes levels with a given number of vertices or triangles, or within an error, as close to M as
 * trials find them. The helper program decimates the step of each trial.
 */
class LevelSimplifier
{
public:
  LevelSimplifier(const DecomposedLeaf<3>& leaf, CarvedLeaf<3>& carved, CarverStages& stages);

  /**
   * Makes the simplified stream: a level for each target that no step of the carving meets as it
   * is, together with the decimated step that it comes from. From coarse to fine, the steps never
   * get earlier. A target that no trial meets gets the closest level, or none. `problems` gets a
   * sentence for each trial that fails. Returns false if the filter is to stop.
   */
  bool Run(const CarverSettings& settings, std::vector<std::string>& problems);

private:
  using TargetList = std::vector<carving::SimplifiedTarget>;

  bool RunTrials(
    const TargetList& targets, std::vector<LevelTrial> trials, double begin, double end);
  bool RunTogether(
    carving::LevelTarget type, double begin, double share, LevelTrial* first, LevelTrial* last);
  std::optional<HelperProcess> Start(carving::LevelTarget type, LevelTrial& trial) const;
  bool Finish(HelperProcess& process, double begin, double end, LevelTrial& trial);
  void DropHopelessTargets(const TargetList& targets, LevelTrial& trial) const;
  double FindLeastError(int step, double enough) const;
  void Choose(const TargetList& targets);
  int AddStep(const LevelTrial& trial);

  CarvedLeaf<3>& Carved;
  CarverStages& Stages;
  const carving::ResolvedMesh& Mesh; ///< M
  double Diagonal;                   ///< of M
  carving::FaceDistance<3> Distance; ///< from M
  std::vector<LevelTrial> Trials;    ///< that have been run
  int Threads = 1;                   ///< that may work at a time
};

#endif
