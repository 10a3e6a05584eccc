// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkExtractCarvedLOD
 * @brief extract a level of detail from the stored stream of a carving
 *
 * The input is the stream that vtkTopologyCarver or vtkContourCarver gives on its output port 1,
 * directly or from a file (.vtu), unchanged. The output is one level. With the same target and
 * ManifoldOutput, the level is bit for bit the one that the carver gives, with the same arrays,
 * which vtkTopologyCarver documents. Nothing is carved again. The first request prepares the
 * stream. All later requests, whatever their target, take time proportional to the size of the
 * stream: milliseconds for 150,000 tetrahedra.
 *
 * For a composite input, the output is a vtkMultiBlockDataSet with the same tree and a level of
 * each stream. GetOutputDataObject(0) returns it.
 *
 * **Errors** are reported through vtkErrorMacro, and the output is then empty: an input that is not
 * a complete stream. The input may come from any file: the first request checks all of it, and the
 * error names the array, the cell or the point that is not valid.
 */
#ifndef vtkExtractCarvedLOD_h
#define vtkExtractCarvedLOD_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkTopologyCarvingModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for problems

class PreparedStreams;
struct PreparedStream;
class vtkMultiBlockDataSet;
class vtkTable;
class vtkUnstructuredGrid;

class VTKTOPOLOGYCARVING_EXPORT vtkExtractCarvedLOD : public vtkPolyDataAlgorithm
{
public:
  static vtkExtractCarvedLOD* New();
  vtkTypeMacro(vtkExtractCarvedLOD, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The quantity that the level target bounds.
   */
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

  /** Whether levels are simplified ones. */
  enum LevelSimplifications
  {
    SUBSET = 0,
    ENCLOSING_COLLAPSE = 1
  };

  ///@{
  /**
   * The quantity that the target bounds: VERTICES (default), TRIANGLES, FEATURE_SIZE, TUNNELS,
   * COMPONENTS, ERROR_BOUND or STEP, each as in vtkTopologyCarver. ERROR_BOUND needs a stream that
   * was carved with ComputeError on, or with such targets; for any other stream it gives the last
   * level and a warning.
   */
  vtkSetClampMacro(LevelTargetType, int, VERTICES, STEP);
  vtkGetMacro(LevelTargetType, int);
  ///@}

  ///@{
  /**
   * The target that picks the level: a number of vertices, triangles, tunnels or components, a
   * length, or a step. At least 0, default 1000. A target that no level meets gives the nearest
   * level and a warning. A number that is not finite is refused with an error.
   */
  void SetLevelTarget(double target);
  vtkGetMacro(LevelTarget, double);
  ///@}

  ///@{
  /**
   * Whether levels are steps of the carving (SUBSET, the default) or simplified levels
   * (ENCLOSING_COLLAPSE), which a carver stores that has its LevelSimplification on. The stream has
   * the decimated steps that were best for the carver's targets, collapse by collapse, so that
   * numbers of vertices and triangles between those targets are reached, too. `Error` is then NaN,
   * except at the carver's targets. ERROR_BOUND gives the coarsest level that was made within the
   * bound, or if there is none, the first carved step within the bound that is no earlier than any
   * simplified level's. What is not stored gives the closest level, and a warning. Without effect
   * on contours.
   */
  vtkSetClampMacro(LevelSimplification, int, SUBSET, ENCLOSING_COLLAPSE);
  vtkGetMacro(LevelSimplification, int);
  ///@}

  ///@{
  /** See vtkTopologyCarver. Default 0: no limit. */
  vtkSetClampMacro(MaximumVertices, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumVertices, int);
  ///@}

  ///@{
  /**
   * Whether the pipeline's time picks the level, so that an animation shows the carving. The times
   * 0, 1, ... NumberOfTimeSteps - 1 stand for levels from C0 to M that are spread like those of the
   * carver's NumberOfLevels. Where a stream has fewer steps, several times stand for the same step.
   * The target picks the level if FollowTime is off, if no time is requested, or if the input has
   * time steps of its own. Default on.
   */
  vtkSetMacro(FollowTime, bool);
  vtkGetMacro(FollowTime, bool);
  vtkBooleanMacro(FollowTime, bool);
  ///@}

  /**
   * Adds the time steps of FollowTime to the information of an output port, unless the information
   * of the input has time steps of its own. Returns whether time picks the level. For filters that
   * contain this one.
   */
  virtual bool OfferTimes(vtkInformation* input, vtkInformation* output);

  ///@{
  /** The number of time steps that FollowTime offers. Range 2 to 100,000, default 50. */
  vtkSetClampMacro(NumberOfTimeSteps, int, 2, 100000);
  vtkGetMacro(NumberOfTimeSteps, int);
  ///@}

  /**
   * The least and the greatest target of a type that pick different levels of the input as it is
   * now, over all its streams, in parallel on all processes. Returns false, with the range 0 to 0,
   * if there is no stream or no such type.
   */
  bool GetLevelTargetRange(int type, double range[2]);

  /**
   * Fills a table with the profile of the input as it is now, like output port 2 of the carver. For
   * a composite input, the profile is that of the first stream on this process. Returns false, with
   * an empty table, if there is no stream.
   */
  bool GetProfile(vtkTable* profile);

  ///@{
  /** Whether the level is cut into oriented manifolds, as in vtkTopologyCarver. Default on. */
  vtkSetMacro(ManifoldOutput, bool);
  vtkGetMacro(ManifoldOutput, bool);
  vtkBooleanMacro(ManifoldOutput, bool);
  ///@}

  /** See vtkAlgorithm. A carver in ParaView asks for the type of its level in this way. */
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

protected:
  vtkExtractCarvedLOD();
  ~vtkExtractCarvedLOD() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  /** Sets a property to a number of at least 0; refuses one that is not finite with an error. */
  void SetNumber(const char* name, double number, double& property);

  /** The least target that is in the range of every leaf; 0 without an input. */
  double GetLeastCommonTarget(int type);

  int LevelTargetType = VERTICES;
  double LevelTarget = 1000.0;
  int LevelSimplification = SUBSET;
  int MaximumVertices = 0;
  bool ManifoldOutput = true;
  bool FollowTime = true;
  int NumberOfTimeSteps = 50;

private:
  vtkExtractCarvedLOD(const vtkExtractCarvedLOD&) = delete;
  void operator=(const vtkExtractCarvedLOD&) = delete;

  std::unique_ptr<PreparedStreams> Streams;
  bool OffersTime = false;

  /**
   * Extract the level for a time, or for the target if `time` is null. Return false after an error.
   * `where` begins the leaf's messages.
   */
  bool ExtractLeaf(
    vtkUnstructuredGrid* grid, const std::string& where, const double* time, vtkPolyData* level);
  bool ExtractTree(vtkDataObject* tree, const std::string& where, const double* time,
    vtkMultiBlockDataSet* levels);
  /** As ExtractLeaf, but may throw std::bad_alloc. */
  bool ExtractLeafUnguarded(
    vtkUnstructuredGrid* grid, const std::string& where, const double* time, vtkPolyData* level);
  /** Extract a step of the carving, or a simplified level. Return why the target is not met. */
  std::string ExtractCarved(
    vtkUnstructuredGrid* grid, PreparedStream& stream, const double* time, vtkPolyData* level);
  std::string ExtractSimplified(
    vtkUnstructuredGrid* grid, PreparedStream& stream, const double* time, vtkPolyData* level);
};

#endif
