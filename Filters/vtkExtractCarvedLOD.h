// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkExtractCarvedLOD
 * @brief a level of detail from the stored stream of a carving
 *
 * Input is the stream that vtkTopologyCarver or vtkContourCarver gives on its output port 1, directly or
 * from a file (.vtu), unchanged. Output is one level: with the same target and ManifoldOutput it is bit
 * for bit the one that the carver gives, with the same arrays, which vtkTopologyCarver documents.
 * Nothing is carved again. The first request prepares the stream; all later ones, whatever the target,
 * take time proportional to the size of the stream, milliseconds for 150,000 tetrahedra.
 *
 * Of a composite input each stream gives its level; the output is then a vtkMultiBlockDataSet with the
 * same tree, which GetOutputDataObject(0) returns.
 *
 * **Errors** are reported through vtkErrorMacro, and the output is then empty: an input that is not a
 * stream or not a whole one. The input may come from any file: the first request checks all of it, and the
 * error names the array, cell or point that is not as it must be.
 */
#ifndef vtkExtractCarvedLOD_h
#define vtkExtractCarvedLOD_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkTopologyCarvingModule.h" // for export macro

#include <memory> // for std::unique_ptr

class vtkMultiBlockDataSet;
class vtkTable;
class vtkUnstructuredGrid;

class VTKTOPOLOGYCARVING_EXPORT vtkExtractCarvedLOD : public vtkPolyDataAlgorithm
{
public:
  static vtkExtractCarvedLOD* New();
  vtkTypeMacro(vtkExtractCarvedLOD, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What the level target is. */
  enum LevelTargets
  {
    VERTICES = 0,
    TRIANGLES = 1,
    FEATURE_SIZE = 2,
    TUNNELS = 3,
    COMPONENTS = 4,
    ERROR_BOUND = 5,
    STEP = 6
  };

  ///@{
  /**
   * What the target is: VERTICES (default), TRIANGLES, FEATURE_SIZE, TUNNELS, COMPONENTS, ERROR_BOUND or
   * STEP, each as in vtkTopologyCarver. ERROR_BOUND is for streams that were carved with ComputeError
   * on, or by such targets; of others it gives the last level and a warning.
   */
  vtkSetClampMacro(LevelTargetType, int, VERTICES, STEP);
  vtkGetMacro(LevelTargetType, int);
  ///@}

  ///@{
  /**
   * The number of vertices, triangles, tunnels or components, the length or the step that picks the level,
   * 0 or more. A target that cannot be met gives the nearest level and a warning. Default 1000.
   */
  vtkSetClampMacro(LevelTarget, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LevelTarget, double);
  ///@}

  ///@{
  /**
   * Whether the pipeline's time picks the level, so that an animation shows the carving: the times 0, 1,
   * ... NumberOfTimeSteps - 1 stand for levels spread from C0 to M as by the carver's NumberOfLevels. If
   * off, if no time is asked for, or if the input has time steps of its own, the target picks it.
   * Default on.
   */
  vtkSetMacro(FollowTime, bool);
  vtkGetMacro(FollowTime, bool);
  vtkBooleanMacro(FollowTime, bool);
  ///@}

  /**
   * Adds the time steps that FollowTime offers to the information of an output port, unless the input's
   * has some of its own, and returns whether it has: for filters that contain this one.
   */
  bool OfferTimes(vtkInformation* input, vtkInformation* output);

  ///@{
  /** The number of time steps that FollowTime offers. Range 2 to 100,000, default 50. */
  vtkSetClampMacro(NumberOfTimeSteps, int, 2, 100000);
  vtkGetMacro(NumberOfTimeSteps, int);
  ///@}

  /**
   * The least and the greatest target of a type that pick different levels of the input as it is now,
   * of all its streams together. Returns false, and 0 and 0, if there is none.
   */
  bool GetLevelTargetRange(int type, double range[2]);

  /**
   * Fills a table with the profile of the input as it is now, as on output port 2 of the carver: of the first
   * stream of a composite input. Returns false, and an empty table, if there is none.
   */
  bool GetProfile(vtkTable* profile);

  ///@{
  /** Whether the level is cut into oriented manifolds, as in vtkTopologyCarver. Default on. */
  vtkSetMacro(ManifoldOutput, bool);
  vtkGetMacro(ManifoldOutput, bool);
  vtkBooleanMacro(ManifoldOutput, bool);
  ///@}

protected:
  vtkExtractCarvedLOD();
  ~vtkExtractCarvedLOD() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  int LevelTargetType = VERTICES;
  double LevelTarget = 1000.0;
  bool ManifoldOutput = true;
  bool FollowTime = true;
  int NumberOfTimeSteps = 50;

private:
  vtkExtractCarvedLOD(const vtkExtractCarvedLOD&) = delete;
  void operator=(const vtkExtractCarvedLOD&) = delete;

  class Internals;
  std::unique_ptr<Internals> Streams;
  bool OffersTime = false;

  /** `time` is null where the target picks the level. Return false after an error. */
  bool ExtractLeaf(vtkUnstructuredGrid* grid, const double* time, vtkPolyData* level);
  bool ExtractTree(vtkDataObject* tree, const double* time, vtkMultiBlockDataSet* levels);
};

#endif
