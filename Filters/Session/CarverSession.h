// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What happens in an update of a carver, and what is kept from one to the next.
 */
#ifndef CarverSession_h
#define CarverSession_h

#include "Core/Measure/Profile.h"
#include "Session/CarverSettings.h"

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkMultiBlockDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/** Where the results for a polydata or a composite of them go. */
struct CarverPorts
{
  vtkMultiBlockDataSet* Levels;
  vtkDataObject* Stream;  ///< vtkUnstructuredGrid, or vtkMultiBlockDataSet for a composite
  vtkDataObject* Profile; ///< vtkTable, or vtkMultiBlockDataSet for a composite
};

/** The stages of an update; those of the helper program, carving::Stage, come first. */
enum CarverStage
{
  TransferStage = carving::NumberOfStages,
  ClassifyStage,
  CarveStage,
  MeasureStage,
  OutputStage,
  NumberOfCarverStages
};
const char* GetCarverStageName(int stage);

/** Whether somebody wants the filter, or one before it in the pipeline, to stop. */
bool IsAborted(vtkAlgorithm* filter);

/** A session for meshes or contours. */
class CarverSessionBase
{
public:
  virtual ~CarverSessionBase() = default;

  /**
   * Carves a vtkPolyData or a composite of them. `initial`, which can be null, is for
   * InitialApproximation::Custom. Returns false if it failed, which has been reported, or was aborted;
   * the ports are then to be emptied.
   */
  virtual bool Update(vtkDataObject* input, vtkPolyData* initial, const CarverSettings& settings,
    const CarverPorts& ports) = 0;

  /** Wall-clock seconds of the last update, all leaves together. */
  double GetStageSeconds(int stage) const
  {
    return this->StageSeconds[stage];
  }

protected:
  std::array<double, NumberOfCarverStages> StageSeconds = {};
};

/**
 * Carves meshes (D = 3) or contours in a plane (D = 2) for a filter, to which it reports progress,
 * errors and warnings, and whose request to abort it follows. What the helper program made is kept
 * until an update of the filter does without it.
 */
template <int D>
class CarverSession : public CarverSessionBase
{
public:
  explicit CarverSession(vtkAlgorithm* filter);
  ~CarverSession() override;

  bool Update(vtkDataObject* input, vtkPolyData* initial, const CarverSettings& settings,
    const CarverPorts& ports) override;

private:
  struct Leaf;
  struct Result;
  class Timer;

  bool CarveLeaf(vtkPolyData* input, const CarverPorts& ports);
  bool CarveTree(vtkDataObject* input, const CarverPorts& ports);
  std::shared_ptr<Leaf> Decompose(vtkPolyData* input);
  bool RunHelper(Leaf& leaf, std::string& error);
  bool Carve(const Leaf& leaf, Result& result);
  /** Fills the profile's errors if they are needed. */
  bool Measure(const Leaf& leaf, Result& result);
  std::vector<int> SelectLevels(const carving::Profile& profile);
  /** Fills a block for each step; returns false if it was aborted. */
  bool WriteLevels(const Result& result, const std::vector<int>& steps, vtkUnstructuredGrid* grid,
    vtkMultiBlockDataSet* levels);
  bool Report(int stage, double fraction);

  vtkAlgorithm* Filter;
  CarverSettings Settings;
  vtkPolyData* Initial = nullptr;
  std::vector<std::shared_ptr<Leaf>> Cache;
  std::vector<std::shared_ptr<Leaf>> Used;
  int NumberOfLeaves = 1;
  int LeavesDone = 0;
};

#endif
