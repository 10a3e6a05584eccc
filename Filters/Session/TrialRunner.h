// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decimates steps of a stream for simplified levels, in the helper program.
 */
#ifndef TrialRunner_h
#define TrialRunner_h

#include "Core/Mesh/FaceDistance.h"
#include "Process/HelperProcess.h"
#include "Session/CarvedLeaf.h"
#include "Session/LevelTrials.h"

#include <optional>
#include <vector>

/** Runs trials, in pairs if a processor is free. */
class TrialRunner
{
public:
  /** The arguments must outlive this object. At most `threads` threads work at a time. */
  TrialRunner(
    const DecomposedLeaf<3>& leaf, const CarvedLeaf<3>& carved, int threads, CarverStages& stages);

  /**
   * Runs trials as a part of the stage, after dropping those of their targets for which a result is
   * known that they could hardly beat. Returns false if the filter is to stop.
   */
  bool Run(const std::vector<carving::SimplifiedTarget>& targets, std::vector<LevelTrial> trials,
    double begin, double end);

  /** The trials that have been run. */
  const std::vector<LevelTrial>& GetTrials() const
  {
    return this->Trials;
  }

private:
  bool RunTogether(
    carving::LevelTarget type, double begin, double share, LevelTrial* first, LevelTrial* last);
  std::optional<HelperProcess> Start(
    carving::LevelTarget type, int threads, LevelTrial& trial) const;
  bool Finish(HelperProcess& process, double begin, double end, LevelTrial& trial);
  void DropHopelessTargets(
    const std::vector<carving::SimplifiedTarget>& targets, LevelTrial& trial) const;
  double FindLeastError(int step, double enough) const;

  const carving::StoredStream<3>& Stream;
  const carving::Profile& Profile;
  CarverStages& Stages;
  const carving::ResolvedMesh& Mesh; ///< M
  double Diagonal;                   ///< of M
  carving::FaceDistance<3> Distance; ///< from M
  std::vector<LevelTrial> Trials;
  int Threads;
};

#endif
