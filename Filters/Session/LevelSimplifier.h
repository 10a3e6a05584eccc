// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Levels by the pair: carved first, then decimated by edge collapses. Not in the paper, which names
 * both together as future work (section 7).
 */
#ifndef LevelSimplifier_h
#define LevelSimplifier_h

#include "Core/Mesh/FaceDistance.h"
#include "Core/Protocol/Protocol.h"
#include "Session/CarvedLeaf.h"

#include <string>
#include <vector>

/** The targets of simplified levels, from coarse to fine. */
std::vector<carving::SimplifiedTarget> MakeSimplifiedTargets(
  const carving::Profile& profile, const CarverSettings& settings);

/**
 * Makes levels with a given number of vertices or triangles, or within an error, as close to M as
 * trials find them.
 *
 * A level with few vertices can be carved up to that number, or be carved further and decimated.
 * Collapses keep the topology of a step, and stick where tunnels and components need all remaining
 * vertices. A trial therefore decimates one step of the stream to all targets. Trials start with
 * the last step; others follow at halved numbers of vertices where the topology differs, because a
 * step of the same topology with fewer vertices only gives levels that are farther from M. A step
 * that is itself farther from M than the results of the trials before is not tried.
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
  struct Trial
  {
    int LastStep; ///< of its targets
    int Step;
    std::vector<double> Targets;
    carving::Decimation Result;
    std::vector<int> Points; ///< of the step's surface, in the stream
    std::vector<int> Cells;  ///< per face of the step's surface: the cell of the stored stream
    int SurfaceComponents;
    int SurfaceGenus;
    std::string Error;
    int Index = -1; ///< in the simplified stream

    const carving::DecimatedSurface* Find(double target) const;
    int CountVertices(const carving::DecimatedSurface& surface) const;
  };

  std::vector<Trial> PlanTrials(const std::vector<carving::SimplifiedTarget>& targets) const;
  bool RunTrial(carving::LevelTarget type, double begin, double share, Trial& trial);
  bool RunTrials(
    carving::LevelTarget type, std::vector<Trial>& trials, std::vector<std::string>& problems);
  void DropHopelessTargets(
    carving::LevelTarget type, const std::vector<Trial>& trials, Trial& trial) const;
  double FindLeastError(int step, double enough) const;
  void Choose(const carving::SimplifiedTarget& target, std::vector<Trial>& trials, int& lastStep);
  void AddStep(Trial& trial);

  CarvedLeaf<3>& Carved;
  CarverStages& Stages;
  const carving::ResolvedMesh& Mesh; ///< M
  carving::FaceDistance<3> Distance; ///< from M
};

#endif
