// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTopologyCarver
 * @brief simplify the topology of a polygonal mesh by carving it out of its convex hull
 *
 * Input is any vtkPolyData, closed or open, manifold or not, one piece or many, or a composite of
 * them. vtkTopologyCarver tetrahedralizes the space between the mesh M and its convex hull C0 and
 * carves the tetrahedra away, those with the longest edge first, until M appears. One run gives a
 * stream of approximations C0, C1, ..., Cn = M in which components split off and tunnels open one
 * after the other. Each of them encloses M, is part of the one before it, does not cross itself and
 * has vertices of M only.
 *
 *                    +--> port 0: vtkMultiBlockDataSet, the levels "LOD 0" (coarsest), "LOD 1", ...
 *   vtkPolyData M ---+--> port 1: vtkUnstructuredGrid, the stream: tetrahedra, triangles, steps
 *                    +--> port 2: vtkTable, the profile: a row per step, row 0 is C0
 *
 * The method is that of "Carving for topology simplification of polygonal meshes" (Computer-Aided
 * Design); the section and equation numbers in this documentation are those of that paper.
 *
 * **Steps.** A step is one pop from the queue of carvable tetrahedra with all that it takes along.
 * Step 0 is C0; a stream of n steps has n + 1 approximations.
 *
 * **Levels** are oriented outward. A triangle of M with solid on neither side, a fold, shows once,
 * oriented as in M. Vertices are doubles and bit for bit those of the input. Where triangles of the
 * input cross each other they are split first; only the points made by that, and Steiner points in
 * the carved space where the tetrahedralization needs some, are new.
 *
 * Arrays of a level:
 * - cells: `Priority` and `Depth` (doubles: q(t) d(t)^-dp and d(t) of equation (2)) of the
 *   tetrahedron behind the face, NaN and 0 for a face of M; `vtkOriginalCellIds`, the input cell,
 *   -1 for a carved face; the input's cell data, 0 on carved faces.
 * - points: the input's point data, exact on input points, on new points interpolated at the
 *   closest point of the input; `vtkOriginalPointIds`, -1 for a new point.
 * - field data: `Step`, `Vertices`, `NewVertices`, `Triangles`, `Kind` ("carved"), `Rung` (how the
 *   mesh was tetrahedralized), `FeatureSize` (the smallest priority popped up to this step, a length;
 *   infinite for C0).
 *
 * Arrays of the stream, whose cells are the tetrahedra between M and C0 and then the triangles of M:
 * `Priority` (when popped), `Depth`, `Step` (of a tetrahedron: it is missing from C_j for j >= Step;
 * of a triangle: the first step at which it shows; -1: never), `Region` (tetrahedra joined by faces
 * that are not of M; -1 for triangles), `vtkOriginalCellIds`, `vtkOriginalPointIds` and the input's
 * data as above.
 *
 * Columns of the profile: `Step`, `Vertices`, `Triangles`, `Priority` (popped at that step).
 *
 * The field data of port 0 has a string array `Notes` if there is something the user should know.
 *
 * **Helper program.** CGAL and TetGen run in a child process, carving-helper, so that no mesh can
 * take this process down and an abort takes effect at once. It is found next to the library or where
 * it was installed, or through the environment variable TOPOLOGYCARVING_HELPER. Its result is kept:
 * changing a property of this filter other than InitialApproximation does not run it again.
 *
 * **Composite input**: the outputs are vtkMultiBlockDataSets with the tree and the names of the
 * input, in which the leaves are replaced by the levels (port 0: a block of blocks), the stream and
 * the profile of each.
 *
 * **Errors** are reported through vtkErrorMacro, and the outputs are then empty: a point that is not
 * finite, a mesh that lies in one plane, a helper program that is missing, dies or gives up.
 */
#ifndef vtkTopologyCarver_h
#define vtkTopologyCarver_h

#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkTopologyCarvingModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <vector> // for the level targets

class CarverSession;

class VTKTOPOLOGYCARVING_EXPORT vtkTopologyCarver : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkTopologyCarver* New();
  vtkTypeMacro(vtkTopologyCarver, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What a stream starts from (section 3.1). */
  enum InitialApproximations
  {
    CONVEX_HULL = 0,
    BOUNDING_BOX = 1
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

  /** What a level target counts. */
  enum LevelTargets
  {
    VERTICES = 0,
    TRIANGLES = 1
  };

  ///@{
  /**
   * The first level, C0. CONVEX_HULL (default) has vertices of the input only. BOUNDING_BOX is the
   * axis-aligned box around the input, grown by one hundredth of its diagonal on every side so that no
   * input point lies on it: coarser to begin with, but its corners are new vertices, and while they
   * last they draw spikes. This is the one property whose change runs the helper program again.
   */
  vtkSetClampMacro(InitialApproximation, int, CONVEX_HULL, BOUNDING_BOX);
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
  vtkSetClampMacro(DepthExponent, double, 0.0, VTK_DOUBLE_MAX);
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
   * narrow, deep cavities (spiking, section 5.2). At least 0, the default: one tetrahedron a step.
   */
  vtkSetClampMacro(BreadthRadius, double, 0.0, VTK_DOUBLE_MAX);
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
   * Which of the regions that M encloses are solid; the others are voids. What reaches the outside
   * without crossing M is neither.
   * - NONZERO_WINDING (default): where the winding number of M is at least one half in magnitude.
   *   Overlapping parts are solid throughout, whichever way they are oriented.
   * - EVEN_ODD: where the path of fewest crossings from the outside crosses an odd number of triangles.
   *   Orientation does not matter; shells within shells are solid and hollow by turns.
   * - SURFACE_ONLY: none. Of a closed mesh the inside is carved too.
   *
   * For a mesh that is open or inconsistently oriented the first two may have to guess; a note says so.
   */
  vtkSetClampMacro(SolidRule, int, NONZERO_WINDING, SURFACE_ONLY);
  vtkGetMacro(SolidRule, int);
  ///@}

  ///@{
  /**
   * Number of levels to spread between C0, the first, and M, the last, so that their vertex counts
   * grow geometrically. Where there are not that many distinct vertex counts, the rest is spread by
   * steps; where there are not that many steps, there are fewer levels. 1 gives M alone. At least
   * 1, default 8. Not used while level targets are set.
   */
  vtkSetClampMacro(NumberOfLevels, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * What the level targets count: VERTICES (default) or TRIANGLES of a level.
   */
  vtkSetClampMacro(LevelTargetType, int, VERTICES, TRIANGLES);
  vtkGetMacro(LevelTargetType, int);
  ///@}

  ///@{
  /**
   * Levels by size: for each target n one level, the last step such that it and all steps before it
   * have at most n vertices or triangles. A target below C0's own count gives C0 and a warning.
   * Levels are sorted from coarse to fine. While any target is set it replaces NumberOfLevels.
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

protected:
  vtkTopologyCarver();
  ~vtkTopologyCarver() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override;

  int InitialApproximation = CONVEX_HULL;
  int PriorityMeasure = LONGEST_EDGE;
  double DepthExponent = 0.0;
  int DepthMeasure = HIERARCHY;
  double BreadthRadius = 0.0;
  bool CarveExposed = true;
  bool CarveVoids = true;
  int SolidRule = NONZERO_WINDING;
  int NumberOfLevels = 8;
  int LevelTargetType = VERTICES;
  std::vector<double> Targets;

private:
  vtkTopologyCarver(const vtkTopologyCarver&) = delete;
  void operator=(const vtkTopologyCarver&) = delete;

  std::unique_ptr<CarverSession> Session;
};

#endif
