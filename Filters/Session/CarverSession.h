// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The updates of a carver, and the results that are kept from one to the next.
 */
#ifndef CarverSession_h
#define CarverSession_h

#include "Session/CarvedLeaf.h"
#include "Session/CarverPorts.h"
#include "Session/CarverSettings.h"
#include "Session/CarverStages.h"

struct CompositeChild;
class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

/** A session for meshes or contours. */
class CarverSessionBase
{
public:
  explicit CarverSessionBase(vtkAlgorithm* filter)
    : Filter(filter)
    , Stages(filter)
  {
  }
  virtual ~CarverSessionBase() = default;

  /**
   * Carves a vtkPolyData or a composite of them. `initial`, which can be null, is for
   * InitialApproximation::Custom. Returns false after an error, which has been reported, or an
   * abort; the caller then empties the ports.
   */
  virtual bool Update(vtkDataObject* input, vtkPolyData* initial, const CarverSettings& settings,
    const CarverPorts& ports) = 0;

  /** Wall-clock seconds of the last update, all leaves together. */
  double GetStageSeconds(int stage) const
  {
    return this->Stages.GetSeconds(stage);
  }

protected:
  vtkAlgorithm* Filter;
  CarverStages Stages;
};

/**
 * Carves meshes (D = 3) or contours in a plane (D = 2) for a filter. The session reports progress,
 * errors and warnings to the filter and obeys its request to abort. Results of the helper program
 * are kept until an update does not use them.
 */
template <int D>
class CarverSession : public CarverSessionBase
{
public:
  explicit CarverSession(vtkAlgorithm* filter)
    : CarverSessionBase(filter)
    , Leaves(filter, this->Stages)
  {
  }

  bool Update(vtkDataObject* input, vtkPolyData* initial, const CarverSettings& settings,
    const CarverPorts& ports) override;

private:
  /** `where` begins the leaf's messages. After an error, the ports are empty. */
  bool UpdateLeaf(vtkPolyData* input, const std::string& where, const CarverPorts& ports);
  /** The same, but may throw std::bad_alloc, and leave ports half filled. */
  bool UpdateLeafUnguarded(vtkPolyData* input, const std::string& where, const CarverPorts& ports);
  /** Makes simplified levels if the settings say so. Returns false if the filter is to stop. */
  bool Simplify(const DecomposedLeaf<D>& leaf, const std::string& where, CarvedLeaf<D>& carved);
  bool UpdateTree(vtkDataObject* input, const std::string& where, const CarverPorts& ports);
  /** Fills the block of a child in the outputs of its parent. */
  void UpdateChild(const CompositeChild& child, const std::string& where, unsigned int index,
    const std::array<vtkMultiBlockDataSet*, 3>& parents);

  CarverSettings Settings;
  DecomposedLeaves<D> Leaves;
};

#endif
