// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Levels by the pair: carved first, then decimated by edge collapses. Not in the paper, which names
 * both together as future work (section 7).
 */
#ifndef LevelSimplifier_h
#define LevelSimplifier_h

#include "Convert/LevelOutput.h"
#include "Core/Protocol/Protocol.h"
#include "Session/CarvedLeaf.h"

#include <string>
#include <vector>

/**
 * Makes levels with a given number of vertices or triangles, or within an error, as close to M as
 * trials find them.
 *
 * A level with few vertices can be carved up to that number, or be carved further and decimated.
 * Collapses keep the topology of a step, and stick where tunnels and components need all remaining
 * vertices. A trial therefore decimates one step of the stream to all targets. Trials start with the
 * last step; others follow at halved numbers of vertices where the topology differs, because a step
 * of the same topology with fewer vertices only gives levels that are farther from M.
 */
class LevelSimplifier
{
public:
  LevelSimplifier(const DecomposedLeaf<3>& leaf, const CarvedLeaf<3>& carved, CarverStages& stages);

  struct Request
  {
    int LastStep;  ///< the level comes from this step or an earlier one
    double Target; ///< of the type that Run is given
  };

  /**
   * Appends a level per request. Requests are sorted from coarse to fine; so are the steps of the
   * levels. A request that no trial meets gets the closest level and a sentence in `problems`; the
   * level is empty if no trial has any. Returns false if the filter is to stop.
   */
  bool Run(carving::DecimationTarget type, const std::vector<Request>& requests,
    std::vector<SimplifiedLevel>& levels, std::vector<std::string>& problems);

private:
  struct Trial
  {
    int Step;
    std::vector<double> Targets;
    std::vector<carving::DecimatedSurface> Results; ///< per target
    std::vector<int> Points;                        ///< of the step's surface, in the stream
    std::vector<carving::FaceLife<3>> Faces;        ///< of the step's surface
    std::string Error;
  };

  std::vector<Trial> PlanTrials(
    carving::DecimationTarget type, const std::vector<Request>& requests) const;
  bool RunTrial(carving::DecimationTarget type, double begin, double share, Trial& trial);
  static SimplifiedLevel MakeLevel(const Trial& trial, const carving::DecimatedSurface& surface);

  const CarvedLeaf<3>& Carved;
  CarverStages& Stages;
  carving::TriangleMesh Mesh; ///< M
};

#endif
