// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The helper program's results, kept from one update to the next.
 */
#ifndef DecomposedLeaf_h
#define DecomposedLeaf_h

#include "Objects/DataVersion.h"
#include "Session/CarverKind.h"
#include "Session/CarverStages.h"
#include "Session/HelperReuse.h"

#include <memory>
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
 * holds.
 */
template <int D>
class DecomposedLeaves
{
public:
  using LeafPointer = std::shared_ptr<const DecomposedLeaf<D>>;

  DecomposedLeaves(vtkAlgorithm* filter, CarverStages& stages)
    : Filter(filter)
    , Stages(stages)
  {
  }

  /**
   * `initial`, which can be null, is for InitialApproximation::Custom. Returns null after an error,
   * which has been reported, and after an abort.
   */
  LeafPointer Get(vtkPolyData* input, vtkPolyData* initial, const HelperSettings& settings);

  /**
   * Drops all results that the finished update has not used. An aborted update may not have reached
   * all.
   */
  void FinishUpdate(bool aborted);

private:
  LeafPointer Decompose(vtkPolyData* input, vtkPolyData* initial, const HelperSettings& settings);
  /** Returns false if the run was aborted. */
  bool RunHelper(DecomposedLeaf<D>& leaf, std::string& error);

  vtkAlgorithm* Filter;
  CarverStages& Stages;
  std::vector<LeafPointer> Kept;
  std::vector<LeafPointer> Used;
};

#endif
