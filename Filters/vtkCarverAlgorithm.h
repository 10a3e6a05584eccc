// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCarverAlgorithm
 * @brief what vtkTopologyCarver and vtkContourCarver have in common: properties, ports, stages
 *
 * The properties are described for meshes in space. For contours in a plane read triangle for
 * tetrahedron, edge for triangle, area for volume and polygon for closed mesh.
 */
#ifndef vtkCarverAlgorithm_h
#define vtkCarverAlgorithm_h

#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkTopologyCarvingModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <vector> // for the level targets

class CarverSessionBase;
struct CarverSettings;
class ObjectExchange;
class vtkMultiProcessController;

class VTKTOPOLOGYCARVING_EXPORT vtkCarverAlgorithm : public vtkMultiBlockDataSetAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkCarverAlgorithm, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What a stream starts from (section 3.1). */
  enum InitialApproximations
  {
    CONVEX_HULL = 0,
    BOUNDING_BOX = 1,
    CUSTOM = 2
  };

  /** q, by which tetrahedra are prioritized (section 4). */
  enum PriorityMeasures
  {
    LONGEST_EDGE = 0,
    VOLUME = 1,
    CIRCUMRADIUS = 2,
    EDGE_VOLUME = 3
  };

  /** d, the depth of a tetrahedron (section 5.3). */
  enum DepthMeasures
  {
    HIERARCHY = 0,
    DISTANCE = 1
  };

  /** Which regions that M encloses are solid. */
  enum SolidRules
  {
    NONZERO_WINDING = 0,
    EVEN_ODD = 1,
    SURFACE_ONLY = 2
  };

  /** Whether M has to be a union of faces of tetrahedra. */
  enum Conformities
  {
    EXACT = 0,
    ENCLOSING = 1,
    AUTO = 2
  };

  /** How folds show; AUTO is a third choice. */
  enum FoldSides
  {
    ONE_SIDE = 0,
    BOTH_SIDES = 1
  };

  /** What a level target counts or measures. */
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
   * The first level, C0. CONVEX_HULL (default) has vertices of the input only. BOUNDING_BOX is the
   * axis-aligned box around the input, grown by one hundredth of its diagonal on every side so that no
   * input point lies on it: coarser to begin with, but its corners are new vertices, and while they
   * last they draw spikes. CUSTOM is the mesh on input port 1: closed, of genus zero, in one piece, free
   * of self-intersections and around the input, which it may touch; an error names each of these that
   * does not hold. Its vertices are new, but for those where the input has one too. A change of this, or
   * of the mesh on port 1 for CUSTOM, runs the helper program again.
   */
  vtkSetClampMacro(InitialApproximation, int, CONVEX_HULL, CUSTOM);
  vtkGetMacro(InitialApproximation, int);
  ///@}

  ///@{
  /**
   * q(t), by which the tetrahedra t are prioritized; the highest is carved first (section 4).
   * - LONGEST_EDGE (default): l, the length of the longest edge. Opens wide gaps before narrow ones
   *   and varies little between neighbors.
   * - VOLUME: v. Removes the most volume early; neighbors differ much, which leaves sharp features.
   * - CIRCUMRADIUS: r, the radius of the circumscribed sphere, at most the hull's diagonal. Close to
   *   rolling a shrinking ball over M; takes flat tetrahedra early.
   * - EDGE_VOLUME: the geometric mean of l and the cube root of v, both of the paper's two terms: slivers,
   *   whose edges are long, come later than by LONGEST_EDGE.
   */
  vtkSetClampMacro(PriorityMeasure, int, LONGEST_EDGE, EDGE_VOLUME);
  vtkGetMacro(PriorityMeasure, int);
  ///@}

  ///@{
  /**
   * dp of equation (2): the priority is q(t) d(t)^-dp, so that the higher the exponent the more evenly
   * carving advances from all sides instead of digging deep (snaking, section 5.1). At least 0, the
   * default, by which depth does not matter.
   */
  void SetDepthExponent(double value)
  {
    this->SetNumber("DepthExponent", value, VTK_DOUBLE_MAX, this->DepthExponent);
  }
  vtkGetMacro(DepthExponent, double);
  ///@}

  ///@{
  /**
   * d(t) of equation (2). HIERARCHY (default): 1 for a tetrahedron on C0, one more than the neighbor
   * whose carving made it carvable for any other. DISTANCE: that of the centroid from the surface of
   * C0, in world units.
   */
  vtkSetClampMacro(DepthMeasure, int, HIERARCHY, DISTANCE);
  vtkGetMacro(DepthMeasure, int);
  ///@}

  ///@{
  /**
   * bp of section 5.4, in world units: a step carves all tetrahedra whose centroid lies within this
   * distance of the popped one's and that a walk among those reaches without crossing M. It avoids
   * narrow, deep cavities (spiking, section 5.2). At least 0, the default: one tetrahedron a step. About
   * the width of the gaps between parts works best; much wider, and a step reaches deep into them
   * again.
   */
  void SetBreadthRadius(double value)
  {
    this->SetNumber("BreadthRadius", value, VTK_DOUBLE_MAX, this->BreadthRadius);
  }
  vtkGetMacro(BreadthRadius, double);
  ///@}

  ///@{
  /**
   * Whether exposed tetrahedra, those with more than one face open to the exterior, are carved in
   * the same step as the neighbor whose carving exposed them (section 3.4). It lowers the number of
   * triangles without changing that of vertices. Default on.
   */
  vtkSetMacro(CarveExposed, bool);
  vtkGetMacro(CarveExposed, bool);
  vtkBooleanMacro(CarveExposed, bool);
  ///@}

  ///@{
  /**
   * Whether voids, regions of the complement that M encloses, are carved too, each from its tetrahedron
   * of highest priority on (section 3). If not, their walls show on no level. Default on.
   */
  vtkSetMacro(CarveVoids, bool);
  vtkGetMacro(CarveVoids, bool);
  vtkBooleanMacro(CarveVoids, bool);
  ///@}

  ///@{
  /**
   * Budgets: the most connected components, tunnels (handles) and voids (hollows) that any level may have,
   * as the closed complex of M, the solid and all that is not carved. A tetrahedron that would exceed one
   * is left until that has changed, or for good, also where it is one of many in a step; so the last
   * level need not be M, and a note says so. Tunnels and pieces, but for walls of voids, are within the
   * budget after cutting into manifolds, too. With 1, 0 and 0 carving ends in a tight wrap of M without
   * gaps or holes: closed, one piece, of genus zero (sheets show with both sides, see KeepBothFoldSides). -1, the default: no limit. The first level
   * has one component, so that 0 components means 1. Tetrahedra are decided on in the order of their
   * priorities: a budget goes to the widest gaps, not to those that would bring levels closest to M.
   *
   * In a plane, triangles take the place of tetrahedra, tunnels are the holes of what is left, and there
   * are no voids.
   */
  vtkSetClampMacro(MaximumComponents, int, -1, VTK_INT_MAX);
  vtkGetMacro(MaximumComponents, int);
  vtkSetClampMacro(MaximumTunnels, int, -1, VTK_INT_MAX);
  vtkGetMacro(MaximumTunnels, int);
  vtkSetClampMacro(MaximumVoids, int, -1, VTK_INT_MAX);
  vtkGetMacro(MaximumVoids, int);
  ///@}

  ///@{
  /**
   * Which of the regions that M encloses are solid; the others are voids. What reaches the outside
   * without crossing M is neither.
   * - NONZERO_WINDING (default): where the winding number of M is at least one half in magnitude.
   *   Overlapping parts are solid throughout, whichever way they are oriented.
   * - EVEN_ODD: where the path of fewest crossings from the outside crosses an odd number of triangles.
   *   Orientation does not matter; shells within shells are solid and hollow by turns.
   * - SURFACE_ONLY: none. Of a closed mesh the inside is carved too.
   *
   * For a mesh that is open or inconsistently oriented the first two may have to guess; a note says so.
   * Where the first attempts at a tetrahedralization failed, what is solid matters for further ones: a
   * change then runs the helper program again.
   */
  vtkSetClampMacro(SolidRule, int, NONZERO_WINDING, SURFACE_ONLY);
  vtkGetMacro(SolidRule, int);
  ///@}

  ///@{
  /**
   * What is done with a mesh that TetGen does not cope with; of no effect on contours.
   * - EXACT: TetGen is tried with up to six orders of the points and triangles and, where M is closed,
   *   without the triangles that have solid on both sides, which no level shows, then with vertices added
   *   on the triangles, up to 10 times M's own and 100,000; then it is an error. The last level is M.
   * - ENCLOSING: Delaunay, which never fails. Tetrahedra that M pierces are kept for good: levels enclose
   *   M and do not cross themselves, but the last only comes near M (see EnclosingTolerance).
   * - AUTO (default): EXACT; where that fails, takes too long or M crosses itself in so many places that
   *   resolving it would multiply it, ENCLOSING.
   *
   * Where EXACT or AUTO would fail otherwise, SnapTolerance lets points be moved.
   *
   * The field data's `Strategy` says what it came to, and notes on port 0 why.
   */
  vtkSetClampMacro(Conformity, int, EXACT, AUTO);
  vtkGetMacro(Conformity, int);
  ///@}

  ///@{
  /**
   * How far the tetrahedra that a mesh pierces, which no level carves, may reach from it in ENCLOSING mode,
   * as a share of the diagonal of the mesh's bounding box. Where they reach farther, vertices are put on
   * the mesh's triangles and near them until they do not, but no more than 10 times the mesh's own and
   * 100,000. The field data's `KeptDistance` says what has been reached. Default 0.02, range 0 to 1; 0: no
   * vertex is added, and levels have the mesh's alone.
   */
  void SetEnclosingTolerance(double value)
  {
    this->SetNumber("EnclosingTolerance", value, 1.0, this->EnclosingTolerance);
  }
  vtkGetMacro(EnclosingTolerance, double);
  ///@}

  ///@{
  /**
   * How far points of the mesh may be moved where TetGen does not cope with it as it is, as a share of the
   * diagonal of its bounding box: points are rounded to a grid, so that what nearly touches touches or
   * vanishes, and resolved again, and TetGen is tried once more. That comes after all else in EXACT and
   * before the mesh is only enclosed in AUTO; it is of no effect in ENCLOSING, on a CUSTOM initial
   * approximation and on contours. M is then the snapped mesh: it is what levels enclose, and what the last
   * is. The field data's `SnapDistance` says how far points have been moved. Of a mesh with much detail
   * that is smaller than the tolerance, only a finer grid can be used, or none. Default 0, range 0 to 1:
   * no point is ever moved. 1e-6 is worth a try.
   */
  void SetSnapTolerance(double value)
  {
    this->SetNumber("SnapTolerance", value, 1.0, this->SnapTolerance);
  }
  vtkGetMacro(SnapTolerance, double);
  ///@}

  ///@{
  /**
   * Whether a mesh that is enclosed only follows its own tightest level as a last one, with the field data
   * `Kind` "input": it may cross itself and need not be a manifold. Default off. Of no effect in exact
   * mode, where the last level is the mesh, and on contours.
   */
  vtkSetMacro(AppendInput, bool);
  vtkGetMacro(AppendInput, bool);
  vtkBooleanMacro(AppendInput, bool);
  ///@}

  ///@{
  /**
   * The most that one attempt at a tetrahedralization may take, in seconds by the clock and in MiB; then it
   * counts as failed. 0, the default: no limit on memory, and processor time in which TetGen does any mesh
   * that it can, so that what comes out does not depend on how busy the machine is.
   */
  void SetTimeLimit(double value)
  {
    this->SetNumber("TimeLimit", value, VTK_DOUBLE_MAX, this->TimeLimit);
  }
  vtkGetMacro(TimeLimit, double);
  void SetMemoryLimit(double value)
  {
    this->SetNumber("MemoryLimit", value, VTK_DOUBLE_MAX, this->MemoryLimit);
  }
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /**
   * Number of levels to spread between C0, the first, and M, the last, so that their vertex counts
   * grow geometrically. Where there are not that many distinct vertex counts, the rest is spread by
   * steps; where there are not that many steps, there are fewer levels. 1 gives M alone. Range 1 to
   * 1,000, since all levels of an update are in memory at once; default 8. Not used while level targets
   * are set.
   */
  vtkSetClampMacro(NumberOfLevels, int, 1, 1000);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * Whether folds, triangles of M with the exterior on both sides, show with both of their sides: the
   * triangle and its opposite-facing copy (section 3.3). ONE_SIDE (off): once each, oriented as in M, so
   * that sheets are open surfaces. BOTH_SIDES (on): levels are closed. AUTO (default): both sides where a
   * budget is set (see MaximumComponents), since only closed surfaces have the pieces and tunnels that it
   * speaks of.
   */
  vtkSetClampMacro(KeepBothFoldSides, int, ONE_SIDE, AUTO);
  vtkGetMacro(KeepBothFoldSides, int);
  vtkBooleanMacro(KeepBothFoldSides, int);
  ///@}

  ///@{
  /**
   * Whether levels are cut into oriented manifolds (section 3.3): no edge has more than two triangles,
   * and the triangles of every vertex form one fan. Where sheets meet in an edge or a vertex, each gets
   * a copy of its points; what bounds a solid stays closed. Parts that touch along several edges in a row
   * stay joined, those that touch in one edge alone, or in a vertex, are cut apart: so cutting opens no
   * tunnel. One side of folds is joined with folds only, so that a tunnel of a solid that sheets close is
   * open on its surface. Default on; off leaves one point per vertex.
   * `Vertices` does not count the copies.
   */
  vtkSetMacro(ManifoldOutput, bool);
  vtkGetMacro(ManifoldOutput, bool);
  vtkBooleanMacro(ManifoldOutput, bool);
  ///@}

  ///@{
  /**
   * Whether the distance of every step from M is computed: the `Error` of a level, of a row of the
   * profile and in the stream, in world units. It is the one-sided Hausdorff distance, of the point of
   * that step's surface that is farthest from M; never too small, and at most a hundredth too large. It
   * takes about ten times as long as carving alone, mostly less than the tetrahedralization or about as
   * long. Default off: `Error` is NaN.
   */
  vtkSetMacro(ComputeError, bool);
  vtkGetMacro(ComputeError, bool);
  vtkBooleanMacro(ComputeError, bool);
  ///@}

  ///@{
  /**
   * What the level targets are: numbers of VERTICES (default) or TRIANGLES of a level, a FEATURE_SIZE,
   * numbers of tunnels (TUNNELS) or COMPONENTS, an ERROR_BOUND or a STEP.
   */
  vtkSetClampMacro(LevelTargetType, int, VERTICES, STEP);
  vtkGetMacro(LevelTargetType, int);
  ///@}

  ///@{
  /**
   * Levels by size, one for each target. VERTICES, TRIANGLES, TUNNELS or COMPONENTS n: the last step such
   * that it and all steps before it have at most n (tunnels may get more and then fewer again); a target
   * below C0's own count gives C0 and a warning. ERROR_BOUND e, a length: the first step such that no
   * point of it or of any step after it is farther than e from M (see ComputeError, which is then taken
   * to be on); where no step is as close, the last and a warning. FEATURE_SIZE
   * s, a length: the last step before a priority of at most s is popped (for VOLUME its cube root, for
   * CIRCUMRADIUS twice it), so that gaps wider than about s are open and narrower ones closed; strict
   * only with DepthExponent and BreadthRadius 0 and CarveExposed off. STEP k: that step, or the nearest
   * and a warning. Levels are sorted from coarse to fine. While any target is set it replaces
   * NumberOfLevels.
   */
  void AddLevelTarget(double target);
  void ClearLevelTargets();
  int GetNumberOfLevelTargets();
  /** Returns 0 if there is no target of that index. */
  double GetLevelTarget(int index);
  ///@}

  ///@{
  /**
   * Wall-clock seconds that each stage of the last update took, summed over the leaves of a composite
   * input. The first stages belong to the helper program and are 0 when its result was reused. An
   * index out of range gives 0 and null.
   */
  int GetNumberOfStages();
  const char* GetStageName(int stage);
  double GetStageSeconds(int stage);
  ///@}

  ///@{
  /**
   * The processes that share the work of a parallel run; by default the global controller, which there
   * is under MPI only. Every object, the input or a leaf of it, is carved whole by one process: the one
   * that has it, or, with a warning, the lowest of those that it is spread over. The others get the same
   * blocks with null or empty data in them.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  /** 3 for meshes in space, 2 for contours in a plane. */
  explicit vtkCarverAlgorithm(int dimension);
  ~vtkCarverAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  /**
   * Whether the last update succeeded with the same inputs and properties, none of which has changed since. In
   * a parallel run the answer is the same on all processes, all of which must ask.
   */
  bool IsUpToDate(vtkInformationVector** in);

  int InitialApproximation = CONVEX_HULL;
  int PriorityMeasure = LONGEST_EDGE;
  double DepthExponent = 0.0;
  int DepthMeasure = HIERARCHY;
  double BreadthRadius = 0.0;
  bool CarveExposed = true;
  bool CarveVoids = true;
  int MaximumComponents = -1;
  int MaximumTunnels = -1;
  int MaximumVoids = -1;
  int SolidRule = NONZERO_WINDING;
  int Conformity = AUTO;
  double EnclosingTolerance = 0.02;
  double SnapTolerance = 0.0;
  bool AppendInput = false;
  double TimeLimit = 0.0;
  double MemoryLimit = 0.0;
  int NumberOfLevels = 8;
  int KeepBothFoldSides = AUTO;
  bool ManifoldOutput = true;
  bool ComputeError = false;
  int LevelTargetType = VERTICES;
  std::vector<double> Targets;

private:
  vtkCarverAlgorithm(const vtkCarverAlgorithm&) = delete;
  void operator=(const vtkCarverAlgorithm&) = delete;

  struct Version;

  CarverSettings GetSettings();
  /** Sets a property to the number within the range; one that is not finite is an error. */
  void SetNumber(const char* name, double number, double greatest, double& property);

  bool WasAborted = false; ///< by the last update
  vtkMultiProcessController* Controller = nullptr;
  std::unique_ptr<CarverSessionBase> Session;
  std::unique_ptr<ObjectExchange> Exchange;
  std::unique_ptr<Version> Done; ///< by the last update, if it succeeded
};

#endif
