// SPDX-License-Identifier: BSD-3-Clause
#include "Session/CarverStages.h"

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <string>

namespace
{

constexpr const char* OwnStageNames[] = { "transfer", "carve", "measure", "simplify", "output" };

/**
 * The fraction of an update at which each stage begins, without and with simplified levels; typical
 * for a mesh of medium size.
 */
constexpr double StageBegins[2][NumberOfCarverStages + 1] = {
  { 0.0, 0.02, 0.2, 0.2, 0.8, 0.82, 0.86, 0.9, 0.93, 0.93, 1.0 },
  { 0.0, 0.005, 0.03, 0.03, 0.15, 0.155, 0.16, 0.17, 0.18, 0.98, 1.0 },
};

} // namespace

const char* GetCarverStageName(int stage)
{
  return stage < carving::NumberOfStages ? carving::StageName(static_cast<carving::Stage>(stage))
                                         : OwnStageNames[stage - carving::NumberOfStages];
}

bool IsAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

void CarverStages::Start(int numberOfLeaves, bool simplifies)
{
  this->Seconds.fill(0.0);
  this->NumberOfLeaves = std::max(1, numberOfLeaves);
  this->LeavesDone = 0;
  this->Greatest = 0.0;
  this->Simplifies = simplifies;
}

bool CarverStages::Report(int stage, double fraction, const std::string& attempt)
{
  const double* begins = StageBegins[this->Simplifies];
  const double ofLeaf = begins[stage] + fraction * (begins[stage + 1] - begins[stage]);
  const double ofAll = (this->LeavesDone + ofLeaf) / this->NumberOfLeaves;
  const std::string name = GetCarverStageName(stage);
  this->Filter->SetProgressText((attempt.empty() ? name : name + ": " + attempt).c_str());
  // Each round of resolving starts at 0 again, but progress never falls.
  this->Greatest = std::max(ofAll, this->Greatest);
  this->Filter->UpdateProgress(this->Greatest);
  return !IsAborted(this->Filter);
}

void CarverStages::AddHelper(
  const std::vector<double>& secondsOfStages, double secondsOfRun, double ownSeconds)
{
  double rest = secondsOfRun;
  for (std::size_t stage = 0; stage < secondsOfStages.size(); ++stage)
  {
    this->Seconds[stage] += secondsOfStages[stage];
    rest -= secondsOfStages[stage];
  }
  this->Seconds[TransferStage] += std::clamp(rest, 0.0, ownSeconds);
}
