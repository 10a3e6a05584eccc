// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkEnclosingDecimation
 * @brief decimate a closed surface into surfaces that enclose it
 *
 * The input is a closed, consistently oriented surface that does not cross itself. Parts of it that
 * are inside out are turned. Each output has fewer vertices, encloses the input (no point of the
 * input lies outside), does not cross itself, and has the same components and tunnels. Edges
 * collapse in the order of a quadric error. Each new vertex lies on the outer side of all faces
 * around its edge ("progressive hull", Sander et al., "Silhouette clipping", 2000), and then slides
 * inward until its faces touch the input. Unless surfaces have to be nested, an edge without an
 * outer side collapses into an end that leaves the input enclosed. This filter is not part of the
 * paper on carving. The work is done by the helper program.
 *
 * For a number of vertices or triangles, an input of up to 30,000 points is decimated twice. The
 * second time, no collapse may make a face that is farther from the input than a bound. The bound
 * rises from about a third of the distance of the first result until the number is reached. The
 * second result is a third to a half closer. Both take three to six times as long as the first.
 *
 * To reduce the number of components or tunnels as well, carve first (vtkTopologyCarver) and
 * decimate a level.
 *
 * | port | output |
 * |---|---|
 * | 0 | vtkPolyData, the surface of the coarsest target |
 * | 1 | vtkMultiBlockDataSet, "LOD 0", "LOD 1", ...: the surfaces of all targets, coarsest first |
 *
 * Points are doubles. Each surface has
 * - point data: those of the input, as the carver passes them on; for new vertices, interpolated at
 *   the closest point of the input. `vtkOriginalPointIds` is the point of the input at the same
 *   position, or -1.
 * - field data: `Vertices`, `NewVertices` (vertices that are not points of the input), `Triangles`,
 *   and `Error`, the largest distance of any point of the surface from the input, which is at most
 *   1 % too large, or more where the surface lies on slivers of the input; `Notes`, an array of
 *   strings, if there is anything to say about the input.
 *
 * Of composite input, the pipeline decimates each block by itself: port 0 has the tree of the
 * input, port 1 the surfaces of the last block alone.
 *
 * A target below the number at which no further edge can collapse gives the coarsest surface
 * that was reached, and a warning. Tunnels need vertices, and so do thin gaps.
 *
 * **Errors** are reported through vtkErrorMacro, and the outputs are then empty: an input that is
 * open, not an oriented manifold or crosses itself, with the first place; the failures of the
 * helper program that vtkTopologyCarver documents.
 */
#ifndef vtkEnclosingDecimation_h
#define vtkEnclosingDecimation_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkTopologyCarvingModule.h" // for export macro

#include <vector> // for the targets

class vtkMultiBlockDataSet;

class VTKTOPOLOGYCARVING_EXPORT vtkEnclosingDecimation : public vtkPolyDataAlgorithm
{
public:
  static vtkEnclosingDecimation* New();
  vtkTypeMacro(vtkEnclosingDecimation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The quantity that a target limits.
   */
  enum Targets
  {
    VERTICES = 0,
    TRIANGLES = 1,
    ERROR_BOUND = 2
  };

  ///@{
  /**
   * The quantity that targets limit: the number of VERTICES (default) or TRIANGLES, or an
   * ERROR_BOUND, a distance from the input in the input's units. An error bound gives the surface
   * that collapses reach as long as no face is farther from the input.
   */
  vtkSetClampMacro(TargetType, int, VERTICES, ERROR_BOUND);
  vtkGetMacro(TargetType, int);
  ///@}

  ///@{
  /**
   * The targets: finite numbers, not negative, in any order. Each target is one surface. Default:
   * a single target of 1000.
   */
  void AddTarget(double target);
  void ClearTargets();
  int GetNumberOfTargets();
  double GetTarget(int i);
  ///@}

  /** Replaces all targets by one. */
  void SetTarget(double target);

  ///@{
  /**
   * Whether every surface lies inside all coarser ones. Off, the default, surfaces are tighter.
   */
  vtkSetMacro(Nested, bool);
  vtkGetMacro(Nested, bool);
  vtkBooleanMacro(Nested, bool);
  ///@}

protected:
  vtkEnclosingDecimation();
  ~vtkEnclosingDecimation() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  int TargetType = VERTICES;
  bool Nested = false;

private:
  vtkEnclosingDecimation(const vtkEnclosingDecimation&) = delete;
  void operator=(const vtkEnclosingDecimation&) = delete;

  /** Fills a block for each target, from coarse to fine. Returns false after an error. */
  bool Decimate(vtkPolyData* input, vtkMultiBlockDataSet* surfaces);

  std::vector<double> AllTargets = { 1000.0 };
  bool WasAborted = false; ///< by the last update
};

#endif
