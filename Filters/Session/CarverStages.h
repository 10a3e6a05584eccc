// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The stages of an update: names, seconds and progress.
 */
#ifndef CarverStages_h
#define CarverStages_h

#include "Core/Protocol/Protocol.h"
#include "Core/Protocol/SecondsSince.h"

#include <array>
#include <chrono>
#include <string>

class vtkAlgorithm;

/** The stages that follow those of the helper program, carving::Stage. */
enum CarverStage
{
  TransferStage = carving::NumberOfStages,
  CarveStage,
  MeasureStage,
  SimplifyStage,
  OutputStage,
  NumberOfCarverStages
};
const char* GetCarverStageName(int stage);

/** Whether the filter, or one before it in the pipeline, has been asked to stop. */
bool IsAborted(vtkAlgorithm* filter);

/** Reports the progress of an update to the filter, and sums up the seconds of each stage. */
class CarverStages
{
public:
  explicit CarverStages(vtkAlgorithm* filter)
    : Filter(filter)
  {
  }

  /**
   * Begins an update of `numberOfLeaves` leaves, each with the same share of the progress. Where
   * the update simplifies levels, most of the progress is that of this stage.
   */
  void Start(int numberOfLeaves, bool simplifies);
  void FinishLeaf()
  {
    ++this->LeavesDone;
  }

  /**
   * Reports that a fraction of a stage of the current leaf is done, in the text of the filter's
   * progress with the attempt that is being made, if any. Returns false if the filter is to stop.
   */
  bool Report(int stage, double fraction, const std::string& attempt = {});

  /** Wall-clock seconds since Start, summed over the leaves. */
  double GetSeconds(int stage) const
  {
    return this->Seconds[stage];
  }

  /**
   * Adds a run of the helper program. The time beyond its stages counts as transfer, up to the
   * seconds that this process has spent on the run: a run that has ended may have waited while
   * another leaf was carved.
   */
  void AddHelper(
    const std::vector<double>& secondsOfStages, double secondsOfRun, double ownSeconds);

  /** Adds to the seconds of a stage during its own lifetime. */
  class Timer
  {
  public:
    Timer(CarverStages& stages, int stage)
      : Seconds(stages.Seconds[stage])
    {
    }
    ~Timer()
    {
      this->Seconds += carving::SecondsSince(this->Start);
    }

  private:
    using Clock = std::chrono::steady_clock;
    double& Seconds;
    Clock::time_point Start = Clock::now();
  };

private:
  vtkAlgorithm* Filter;
  std::array<double, NumberOfCarverStages> Seconds = {};
  int NumberOfLeaves = 1;
  int LeavesDone = 0;
  double Greatest = 0.0; ///< fraction that has been reported
  bool Simplifies = false;
};

#endif
