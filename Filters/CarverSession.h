// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What happens in an update of vtkTopologyCarver, and what is kept from one to the next.
 */
#ifndef CarverSession_h
#define CarverSession_h

#include "Carver.h"
#include "Profile.h"
#include "Protocol.h"

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkFieldData;
class vtkMultiBlockDataSet;
class vtkPolyData;
struct CarvedMesh;

/** The properties of the filter that an update depends on. */
struct CarverSettings
{
  carving::InitialApproximation Initial = carving::InitialApproximation::ConvexHull;
  carving::SolidRule Solid = carving::SolidRule::NonzeroWinding;
  carving::CarveOptions Carve;
  bool DepthIsDistance = false; ///< from C0, instead of the level in the hierarchy
  int NumberOfLevels = 8;
  std::vector<double> LevelTargets; ///< replace NumberOfLevels if there are any
  bool TargetsAreTriangles = false;
};

/** Where the results for a polydata or a composite of them go. */
struct CarverPorts
{
  vtkMultiBlockDataSet* Levels;
  vtkDataObject* Stream;  ///< vtkUnstructuredGrid, or vtkMultiBlockDataSet for a composite
  vtkDataObject* Profile; ///< vtkTable, or vtkMultiBlockDataSet for a composite
};

/**
 * Carves meshes for a filter, to which it reports progress, errors and warnings, and whose request to
 * abort it follows. Tetrahedralizations are kept until an update of the filter does without them.
 */
class CarverSession
{
public:
  /** The stages of an update; those of the helper program, carving::Stage, come first. */
  enum Stage
  {
    Transfer = carving::NumberOfStages,
    Classify,
    Carve,
    Output,
    NumberOfStages
  };
  static const char* GetStageName(int stage);

  explicit CarverSession(vtkAlgorithm* filter);
  ~CarverSession();

  /**
   * Carves a vtkPolyData or a composite of them. Returns false if it failed, which has been reported,
   * or was aborted; the ports are then to be emptied.
   */
  bool Update(vtkDataObject* input, const CarverSettings& settings, const CarverPorts& ports);

  /** Wall-clock seconds of the last update, all leaves together. */
  double GetStageSeconds(int stage) const
  {
    return this->StageSeconds[stage];
  }

private:
  struct Leaf;
  class Timer;

  bool CarveLeaf(vtkPolyData* input, const CarverPorts& ports);
  bool CarveTree(vtkDataObject* input, const CarverPorts& ports);
  std::shared_ptr<Leaf> Tetrahedralize(vtkPolyData* input);
  bool CarveTetrahedra(CarvedMesh& carved);
  std::vector<int> SelectLevels(const carving::Profile& profile);
  bool Report(int stage, double fraction);

  vtkAlgorithm* Filter;
  CarverSettings Settings;
  std::array<double, NumberOfStages> StageSeconds = {};
  std::vector<std::shared_ptr<Leaf>> Cache;
  std::vector<std::shared_ptr<Leaf>> Used;
  int NumberOfLeaves = 1;
  int LeavesDone = 0;
};

#endif
