// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The helper program's results, kept from one update to the next.
 */
#ifndef DecomposedLeaf_h
#define DecomposedLeaf_h

#include "Objects/DataVersion.h"
#include "Process/HelperProcess.h"
#include "Session/CarverKind.h"
#include "Session/CarverStages.h"
#include "Session/HelperReuse.h"
#include "vtkType.h"

#include <chrono>
#include <deque>
#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkPolyData;

/** A leaf of the input and its decomposition, the helper program's reply. */
template <int D>
struct DecomposedLeaf
{
  DataVersion Given;
  DataVersion GivenInitial; ///< for InitialApproximation::Custom
  HelperSettings Settings;  ///< of the helper program's run
  typename Kind<D>::Input Input;
  typename Kind<D>::Input Initial;
  bool Empty = false; ///< nothing to decompose: there is no reply
  carving::Reply Reply;
};

/**
 * Runs the helper program for a leaf, or gives the leaf's result of an earlier update if that still
 * holds. Programs for the next leaves run meanwhile.
 */
template <int D>
class DecomposedLeaves
{
public:
  using LeafPointer = std::shared_ptr<DecomposedLeaf<D>>;

  DecomposedLeaves(vtkAlgorithm* filter, CarverStages& stages)
    : Filter(filter)
    , Stages(stages)
  {
  }

  /**
   * Begins an update that will ask for leaves in this order. `initial`, which can be null, is for
   * InitialApproximation::Custom. At most `numberOfThreads` programs run at a time, one less while
   * the caller works on a leaf; each may use `threadsOfLeaf` processors.
   */
  void Start(const std::vector<vtkPolyData*>& inputs, vtkPolyData* initial,
    const HelperSettings& settings, int numberOfThreads, int threadsOfLeaf);

  /**
   * Returns null after an error, which has been reported, and after an abort. `where` begins the
   * message.
   */
  LeafPointer Get(vtkPolyData* input, const std::string& where);

  /**
   * Drops all results that the finished update has not used. An aborted update may not have reached
   * all.
   */
  void FinishUpdate(bool aborted);

private:
  using Clock = std::chrono::steady_clock;

  /** A leaf for which the helper program runs, unless the leaf is empty or there is an error. */
  struct Run
  {
    std::shared_ptr<DecomposedLeaf<D>> Leaf;
    HelperProcess Process;
    bool IsStarted = false;
    bool IsWaitedFor = false;
    std::string Error;
    vtkIdType NumberOfPoints = 0;
    vtkIdType NumberOfCells = 0;
    Clock::time_point Begin; ///< of handing the job over
    double Seconds = 0.0;    ///< that this process has spent on handing over and waiting
  };

  LeafPointer FindKept(vtkPolyData* input) const;
  typename std::deque<Run>::iterator FindRun(vtkPolyData* input);
  void StartRun(vtkPolyData* input);
  void Start(vtkPolyData* input, Run& run);
  void StartNext();
  std::size_t CountRunning();
  bool HasMemoryFor(vtkPolyData* input) const;
  LeafPointer FinishRun(Run& run, const std::string& where);

  vtkAlgorithm* Filter;
  CarverStages& Stages;
  std::vector<LeafPointer> Kept;
  std::vector<LeafPointer> Used;

  std::deque<vtkPolyData*> Upcoming; ///< the leaves that have not been started
  vtkPolyData* Initial = nullptr;
  HelperSettings Settings;
  std::size_t NumberOfThreads = 1;
  int ThreadsOfLeaf = 1;
  std::deque<Run> Runs; ///< in the order of the leaves
};

#endif
