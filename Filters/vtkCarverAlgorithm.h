// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCarverAlgorithm
 * @brief the common base of vtkTopologyCarver and vtkContourCarver: properties, ports, stages
 *
 * The properties are described for meshes in space. For contours in a plane, read triangle for
 * tetrahedron, edge for triangle, area for volume and polygon for closed mesh. The classes document
 * their outputs, and the terms M (the input) and C0 (the first level).
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

  /** The first level, C0 (section 3.1). */
  enum InitialApproximations
  {
    CONVEX_HULL = 0,
    BOUNDING_BOX = 1,
    CUSTOM = 2
  };

  /** The measure q of a tetrahedron, which its priority follows (section 4). */
  enum PriorityMeasures
  {
    LONGEST_EDGE = 0,
    VOLUME = 1,
    CIRCUMRADIUS = 2,
    EDGE_VOLUME = 3,
    EDGE_DISTANCE = 4,
    AUTO_MEASURE = 5
  };

  /** The depth d of a tetrahedron (section 5.3). */
  enum DepthMeasures
  {
    HIERARCHY = 0,
    DISTANCE = 1
  };

  /** The rule for which of the regions that M encloses are solid. Not in the paper. */
  enum SolidRules
  {
    NONZERO_WINDING = 0,
    EVEN_ODD = 1,
    SURFACE_ONLY = 2
  };

  /** Whether M must be a union of faces of tetrahedra. Enclosing is not in the paper. */
  enum Conformities
  {
    EXACT = 0,
    ENCLOSING = 1,
    AUTO = 2
  };

  /** How triangles of M become faces of tetrahedra. AUTO is a third choice. Not in the paper. */
  enum Strategies
  {
    TETGEN = 0,
    RECOVER = 1
  };

  /** The number of sides that folds show. AUTO is a third choice. */
  enum FoldSides
  {
    ONE_SIDE = 0,
    BOTH_SIDES = 1
  };

  /** The quantity that a level target bounds. */
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

  /** The class of the data on output port 0. */
  enum OutputTypes
  {
    MULTIBLOCK = 0,
    PARTITIONED_COLLECTION = 1
  };

  /** Whether levels are decimated after carving. Not in the paper. */
  enum LevelSimplifications
  {
    SUBSET = 0,
    ENCLOSING_COLLAPSE = 1
  };

  ///@{
  /**
   * The first level, C0. A change runs the helper program again, and so does, for CUSTOM, a change
   * of the mesh on input port 1.
   * - CONVEX_HULL (default): has vertices of the input only.
   * - BOUNDING_BOX: the axis-aligned box around the input, grown by one hundredth of its diagonal
   *   on every side so that no input point lies on it. The box is coarser than the hull, but its
   *   corners are new vertices, and levels have spikes towards them as long as they last.
   * - CUSTOM: the mesh on input port 1. It must be closed, of genus zero, connected, free of
   *   self-intersections, and around the input, which it may touch. An error names the condition
   *   that does not hold. The vertices of the mesh are new, except where the input has an equal
   *   vertex.
   */
  vtkSetClampMacro(InitialApproximation, int, CONVEX_HULL, CUSTOM);
  vtkGetMacro(InitialApproximation, int);
  ///@}

  ///@{
  /**
   * The measure q(t) of a tetrahedron t. The tetrahedron with the highest priority is carved first
   * (section 4).
   * - LONGEST_EDGE: the length l of the longest edge. Wide gaps open before narrow ones, and the
   *   measure varies little between neighbors.
   * - VOLUME: the volume v. Most of the volume is removed early. The measure varies much between
   *   neighbors, which leaves sharp features.
   * - CIRCUMRADIUS: the radius of the circumscribed sphere, at most the diagonal of the hull. The
   *   order is close to rolling a shrinking ball over M. Flat tetrahedra are carved early.
   * - EDGE_VOLUME: the geometric mean of l and the cube root of v, which are the two terms of the
   *   paper. Slivers have long edges and small volumes, so that they are carved later than with
   *   LONGEST_EDGE.
   * - EDGE_DISTANCE: the cube root of l d^2, where d is the distance of the centroid from M.
   *   Tetrahedra that have long edges because the triangles of M have are carved later than with
   *   LONGEST_EDGE, so that levels come closer to M with fewer vertices. Not in the paper.
   * - AUTO_MEASURE (default): EDGE_DISTANCE with LevelSimplification ENCLOSING_COLLAPSE, and
   *   LONGEST_EDGE otherwise.
   */
  vtkSetClampMacro(PriorityMeasure, int, LONGEST_EDGE, AUTO_MEASURE);
  vtkGetMacro(PriorityMeasure, int);
  ///@}

  ///@{
  /**
   * The exponent dp of equation (2), by which the priority is q(t) d(t)^-dp. The higher the
   * exponent, the more evenly carving advances from all sides instead of digging deep (snaking,
   * section 5.1). At least 0; with 0, the default, depth does not matter.
   */
  void SetDepthExponent(double value)
  {
    this->SetNumber("DepthExponent", value, VTK_DOUBLE_MAX, this->DepthExponent);
  }
  vtkGetMacro(DepthExponent, double);
  ///@}

  ///@{
  /**
   * The depth d(t) of equation (2). HIERARCHY (default): 1 for a tetrahedron on C0; for any other,
   * one more than the depth of the neighbor whose carving made it carvable. DISTANCE: the distance
   * of the centroid from the surface of C0, in world units; at least 1e-9 of M's diagonal.
   */
  vtkSetClampMacro(DepthMeasure, int, HIERARCHY, DISTANCE);
  vtkGetMacro(DepthMeasure, int);
  ///@}

  ///@{
  /**
   * The radius bp of section 5.4, in world units. A step carves the popped tetrahedron and all
   * others whose centroid lies within this distance of its centroid, and which a walk among those
   * reaches without crossing M. The radius avoids narrow, deep cavities (spiking, section 5.2). At
   * least 0; with 0, the default, a step starts from one tetrahedron only. A radius of about the
   * width of the gaps between parts works best. With a much larger radius, a step reaches deep into
   * the gaps again.
   */
  void SetBreadthRadius(double value)
  {
    this->SetNumber("BreadthRadius", value, VTK_DOUBLE_MAX, this->BreadthRadius);
  }
  vtkGetMacro(BreadthRadius, double);
  ///@}

  ///@{
  /**
   * Whether exposed tetrahedra are carved in the same step as the neighbor whose carving exposed
   * them (section 3.4). A tetrahedron is exposed if more than one of its faces is open to the
   * exterior. This lowers the number of triangles without changing the number of vertices. Default
   * on.
   */
  vtkSetMacro(CarveExposed, bool);
  vtkGetMacro(CarveExposed, bool);
  vtkBooleanMacro(CarveExposed, bool);
  ///@}

  ///@{
  /**
   * Whether voids are carved, too. A void is a region of the complement that M encloses; its
   * carving starts from its tetrahedron of highest priority (section 3). If off, the walls of voids
   * show on no level. Default on.
   */
  vtkSetMacro(CarveVoids, bool);
  vtkGetMacro(CarveVoids, bool);
  vtkBooleanMacro(CarveVoids, bool);
  ///@}

  ///@{
  /**
   * Budgets: the largest numbers of connected components, tunnels (handles) and voids (hollows)
   * that any level may have. The numbers are those of the closed complex K, the union of M, the
   * solid and all tetrahedra that are not yet carved. -1, the default, means no limit. Budgets are
   * not in the paper.
   *
   * A tetrahedron that would exceed a budget is not carved, neither alone nor with others in a
   * step, until its removal would no longer exceed the budget. So the last level may differ from M;
   * then a note says so. Components and tunnels are within the budget after cutting into manifolds,
   * too, if the walls of voids are not counted as components. With 1, 0 and 0, carving ends in a
   * tight wrap of M without gaps or holes: closed, connected, of genus zero (sheets show both
   * sides, see KeepBothFoldSides). The first level has one component, so that 0 components means 1.
   * Tetrahedra are decided in the order of their priorities: a budget is spent on the widest gaps,
   * not on the gaps that would bring the levels closest to M.
   *
   * In a plane, triangles take the place of tetrahedra, tunnels are the holes of K, and there are
   * no voids.
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
   * Which of the regions that M encloses are solid. The other enclosed regions are voids. A region
   * that reaches the outside without crossing M is neither. The rules are not in the paper.
   * - NONZERO_WINDING (default): the regions where the winding number of M is at least one half in
   *   magnitude. Overlapping parts are solid throughout, whatever their orientation. The triangles
   *   of a part count as oriented alike if each of its edges has two: those of less area are
   *   turned.
   * - EVEN_ODD: the regions where the path of fewest crossings from the outside crosses an odd
   *   number of triangles. Orientation does not matter. Nested shells are alternately solid and
   *   hollow.
   * - SURFACE_ONLY: none. The inside of a closed mesh is carved, too.
   *
   * Triangles are added across cracks that are narrower than a millionth of M's diagonal, through
   * which the solid would be connected to the outside; then a note gives their number. Where edges
   * of tetrahedra pass through a crack, vertices are added in the crack. Such cracks open where
   * vertices lie on edges of other triangles and coordinates are rounded.
   *
   * For a mesh that is open or inconsistently oriented, the first two rules may have to guess; then
   * a note says so. Seals of cracks depend on the rule, and so do further attempts at a
   * tetrahedralization if the first ones failed: a change of the rule then runs the helper program
   * again.
   */
  vtkSetClampMacro(SolidRule, int, NONZERO_WINDING, SURFACE_ONLY);
  vtkGetMacro(SolidRule, int);
  ///@}

  ///@{
  /**
   * The treatment of a mesh that TetGen cannot tetrahedralize. Without effect on contours.
   * - EXACT: TetGen is tried with two orders of the points and triangles. If M does not cross
   *   itself, its triangles are recovered in a Delaunay tetrahedralization before, between or after
   *   these attempts (see Strategy), with vertices off M where that is necessary. If M
   *   is closed, TetGen is then tried without the triangles that have solid on both sides, which no
   *   level shows. The next attempts add vertices on the triangles, at most 10 for each of M's own,
   *   plus 100,000, and may cut the parts of a triangle in another way. If all attempts fail, the
   *   result is an error. The last level is M.
   * - ENCLOSING: a Delaunay tetrahedralization, which always succeeds. Tetrahedra that M pierces
   *   are never carved: levels enclose M and do not cross themselves. Triangles are recovered as
   *   faces as far as possible. Along the others, the tetrahedra are cut, with vertices on the
   *   triangles. The last level approximates the remaining triangles (see EnclosingTolerance). If M
   *   crosses itself, the resolved M may take its place, where more of that is met.
   * - AUTO (default): EXACT, and ENCLOSING if that fails or takes too long, or if M crosses itself
   *   in so many places that resolving would multiply its size.
   *
   * With SnapTolerance, points may be moved where EXACT or AUTO would fail otherwise.
   *
   * The array `Strategy` of the field data names the attempt that succeeded, and the notes on port
   * 0 say why others failed.
   */
  vtkSetClampMacro(Conformity, int, EXACT, AUTO);
  vtkGetMacro(Conformity, int);
  ///@}

  ///@{
  /**
   * The attempts that Conformity makes before a mesh is only enclosed. Without effect in ENCLOSING
   * mode, which never runs TetGen and always recovers, and on contours.
   * - TETGEN: those of TetGen.
   * - RECOVER: recovery in a Delaunay tetrahedralization alone. TetGen is not run. A mesh that does
   *   not cross itself is mostly met as a whole, and no vertex is added on its triangles; where
   *   crossings had to be resolved, recovery mostly fails.
   * - AUTO (default): both on a mesh that does not cross itself, TetGen alone on others. Recovery
   *   comes first where it takes less time than TetGen: on meshes of well-shaped triangles, such as
   *   scans, most of whose triangles a Delaunay tetrahedralization has anyway. Elsewhere it follows
   *   where TetGen's first attempt fails.
   */
  vtkSetClampMacro(Strategy, int, TETGEN, AUTO);
  vtkGetMacro(Strategy, int);
  ///@}

  ///@{
  /**
   * The distance that the tetrahedra that a mesh pierces, which are never carved, may reach from
   * the mesh in ENCLOSING mode, as a share of the diagonal of the mesh's bounding box. Where they
   * reach farther, they are halved until the tolerance holds, with at most 10 vertices for each of
   * the mesh's own, plus 100,000. Rounding can prevent this where many points are nearly in one
   * plane. The array `KeptDistance` of the field data has the distance that has been reached,
   * `KeptDistance99` the distance of all but a hundredth of the tetrahedra's surface,
   * `KeptDistanceMean` the mean over this surface, and `MetShare` the share of the mesh's area that
   * is met exactly. Range 0 to 1, default 0.02. With 0, no vertex is added, neither to cut nor to
   * halve, and levels have vertices of the mesh only.
   */
  void SetEnclosingTolerance(double value)
  {
    this->SetNumber("EnclosingTolerance", value, 1.0, this->EnclosingTolerance);
  }
  vtkGetMacro(EnclosingTolerance, double);
  ///@}

  ///@{
  /**
   * The distance that points of the mesh may be moved if TetGen cannot tetrahedralize the mesh as
   * given, as a share of the diagonal of the mesh's bounding box. First, parts that are flat within
   * it get other triangles of the same points, as the Delaunay tetrahedralization has them: the
   * ends of cylinders, for example. Then, points, edges and triangles that are closer to each other
   * than a quarter of it are taken to touch, and are split where they do: given points keep their
   * places, unless several become one. If TetGen fails on that mesh, too, all points are rounded to
   * a grid, so that parts that nearly touch do touch or vanish, and the mesh is resolved again. In
   * EXACT mode, snapping is the last attempt; in AUTO mode, it comes before the mesh is only
   * enclosed. Where a mesh is enclosed and triangles of flat parts cannot be recovered, these parts
   * get other triangles, but no point is moved. Snapping is without effect on a CUSTOM initial
   * approximation and on contours. M is then the snapped mesh: levels enclose the snapped mesh, and
   * the last level is the snapped mesh. The array `SnapDistance` of the field data has the largest
   * distance by which a point was moved, or of a new triangle from the given ones. If a mesh has
   * many details that are smaller than the tolerance, only a finer grid can be used, or none.
   *
   * Range 0 to 1. The default, 1e-12, removes roundings: points that should be in one plane or in
   * one place, and crossings closer than TetGen can tell apart. Points in single precision stay
   * where they are, except for coordinates within 2e-5 of the diagonal from 0. With 0, no point is
   * ever moved. If parts of the mesh nearly touch, 1e-6 is worth a try. Snapping is not in the
   * paper.
   */
  void SetSnapTolerance(double value)
  {
    this->SetNumber("SnapTolerance", value, 1.0, this->SnapTolerance);
  }
  vtkGetMacro(SnapTolerance, double);
  ///@}

  ///@{
  /**
   * Whether a mesh that is only enclosed follows its own tightest level as the last level, with
   * `Kind` "input" in the field data. That level may cross itself and need not be a manifold. Its
   * cell data `MetShare` says which triangles are met exactly. Without effect in exact mode, where
   * the last level is the mesh, and on contours. Default off.
   */
  vtkSetMacro(AppendInput, bool);
  vtkGetMacro(AppendInput, bool);
  vtkBooleanMacro(AppendInput, bool);
  ///@}

  ///@{
  /**
   * The time and the memory that one attempt at a tetrahedralization may take, in seconds of
   * wall-clock time and in MiB. An attempt that exceeds a limit counts as failed. 0, the default,
   * means no limit on memory, and for time a limit in processor time that suffices for every mesh
   * that TetGen can tetrahedralize, so that the result does not depend on how busy the machine is.
   * In AUTO mode, all attempts at an exact tetrahedralization together get 10 seconds and 0.1
   * milliseconds per triangle of processor time, or TimeLimit if that is more; attempts at a
   * snapped mesh get a quarter more. In the portable build, the limit on memory has no effect.
   *
   * Without a MemoryLimit, a mesh is refused if it needs more memory than the machine has. The need
   * is estimated from the numbers of vertices and triangles.
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
   * The number of levels from C0, the first, to M, the last, whose vertex counts grow
   * geometrically. If there are fewer distinct vertex counts, the remaining levels are spread by
   * steps; if there are fewer steps, there are fewer levels. 1 gives M alone. Range 1 to 1,000,
   * since all levels of an update are in memory at the same time; default 8. Not used while level
   * targets are set.
   */
  vtkSetClampMacro(NumberOfLevels, int, 1, 1000);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * Whether folds, which are triangles of M with the exterior on both sides, show both of their
   * sides: the triangle and its opposite-facing copy (section 3.3).
   * - ONE_SIDE (off): folds show once, oriented as in M, so that sheets are open surfaces.
   * - BOTH_SIDES (on): levels are closed.
   * - AUTO (default): both sides if a budget is set (see MaximumComponents), since only closed
   *   surfaces have the components and tunnels that the budget limits, and with
   *   ENCLOSING_COLLAPSE, which needs closed surfaces.
   */
  vtkSetClampMacro(KeepBothFoldSides, int, ONE_SIDE, AUTO);
  vtkGetMacro(KeepBothFoldSides, int);
  vtkBooleanMacro(KeepBothFoldSides, int);
  ///@}

  ///@{
  /**
   * Whether levels are cut into oriented manifolds (section 3.3): no edge has more than two
   * triangles, and the triangles of every vertex form one fan. Where sheets meet in an edge or a
   * vertex, each sheet gets its own copy of the points; the boundary of a solid stays closed. Parts
   * that touch along several consecutive edges stay joined. Parts that touch in a single edge or
   * vertex are cut apart. So cutting opens no tunnel. One side of a fold is joined with other folds
   * only, so that a tunnel of a solid that sheets close is open on the surface of the solid.
   * Default on; if off, every vertex has one point. `Vertices` does not count the copies.
   */
  vtkSetMacro(ManifoldOutput, bool);
  vtkGetMacro(ManifoldOutput, bool);
  vtkBooleanMacro(ManifoldOutput, bool);
  ///@}

  ///@{
  /**
   * The class of the levels on output port 0.
   * - MULTIBLOCK (default): a vtkMultiBlockDataSet with a block per level.
   * - PARTITIONED_COLLECTION: a vtkPartitionedDataSetCollection with a partitioned data set of one
   *   partition per level, and the names (and for a composite input, the tree) in its data
   *   assembly. GetOutput() is null then; GetOutputDataObject(0) has the levels.
   */
  vtkSetClampMacro(OutputType, int, MULTIBLOCK, PARTITIONED_COLLECTION);
  vtkGetMacro(OutputType, int);
  ///@}

  ///@{
  /**
   * The number of processors to use. As many leaves of a composite input are worked on at a time:
   * while one is carved, helper programs decompose the next ones. Fewer run where the memory of the
   * machine would not suffice. If there are more processors than leaves, several work on each leaf:
   * TetGen runs while crossings are searched for, winding numbers, the profile and levels are
   * computed by several threads, and trials of simplified levels run beside each other. The outputs
   * do not depend on this number. With 0, the default, as many as
   * vtkSMPTools::GetEstimatedNumberOfThreads() says. From 0 to 1024.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Whether the decompositions that the helper program makes are kept, so that it need not run
   * again if only properties of the carving or of the levels change. A filter that updates once
   * takes less time and memory without. The outputs do not depend on this property. Default: on.
   */
  vtkSetMacro(ReuseDecomposition, bool);
  vtkGetMacro(ReuseDecomposition, bool);
  vtkBooleanMacro(ReuseDecomposition, bool);
  ///@}

  ///@{
  /**
   * How levels get their numbers of vertices. Without effect on contours.
   * - SUBSET (default): levels are steps of the carving. They have vertices of the input only.
   * - ENCLOSING_COLLAPSE: a step that has been carved further is decimated by edge collapses, as in
   *   vtkEnclosingDecimation. Such a level is many times closer to M than a step with the same
   *   number of vertices. It encloses M, does not cross itself, is closed and has the topology of
   *   the step, but has new vertices, and need not lie inside coarser levels. Its field data have
   *   `Kind` "simplified", the `Step` that it comes from, and its `Error`. A triangle has the cell
   *   data of the step's triangle that it has been; new vertices have the point data of the closest
   *   point of the input.
   *
   * With ENCLOSING_COLLAPSE, targets of VERTICES and TRIANGLES, and those of NumberOfLevels, give
   * the closest level of several trials: steps at halved numbers of vertices, and between the best
   * ones, decimated to the target, and the best ones again with bounds on the distance of the
   * triangles that are made. C0's own number is no limit. ERROR_BOUND gives the level with the
   * fewest vertices that the trials find within the distance, or if there is none, a step of the
   * carving as it is, or else, with a warning, the closest level. For all other targets, see
   * MaximumVertices. The helper program runs once for each trial. The stored stream on port 1 keeps
   * the decimated steps, from which vtkExtractCarvedLOD gives simplified levels.
   */
  vtkSetClampMacro(LevelSimplification, int, SUBSET, ENCLOSING_COLLAPSE);
  vtkGetMacro(LevelSimplification, int);
  ///@}

  ///@{
  /**
   * The largest number of vertices of a level whose target is a number of TUNNELS or COMPONENTS, a
   * FEATURE_SIZE or a STEP: with ENCLOSING_COLLAPSE, the target's step, or an earlier one, is
   * decimated to this number. 0, the default, means no limit. Not used by other targets, nor with
   * SUBSET.
   */
  vtkSetClampMacro(MaximumVertices, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumVertices, int);
  ///@}

  ///@{
  /**
   * Whether the distance of every step from M is computed, in world units: the `Error` of a level,
   * of a row of the profile and in the stream. The distance is the one-sided Hausdorff distance:
   * that of the point of the step's surface that is farthest from M. It is never too small, and at
   * most one hundredth, or a millionth of the mesh's diagonal, too large. The computation takes
   * about ten times as long as carving alone, usually less than or about as long as the
   * tetrahedralization. Default off: `Error` is NaN. Distances are not in the paper.
   */
  vtkSetMacro(ComputeError, bool);
  vtkGetMacro(ComputeError, bool);
  vtkBooleanMacro(ComputeError, bool);
  ///@}

  ///@{
  /**
   * The quantity that the level targets bound: the number of VERTICES (default) or TRIANGLES of a
   * level, a FEATURE_SIZE, the number of tunnels (TUNNELS) or COMPONENTS, an ERROR_BOUND or a STEP.
   */
  vtkSetClampMacro(LevelTargetType, int, VERTICES, STEP);
  vtkGetMacro(LevelTargetType, int);
  ///@}

  ///@{
  /**
   * Targets for levels, each of which gives one level. While any target is set, the targets replace
   * NumberOfLevels. Levels are sorted from coarse to fine.
   * - VERTICES, TRIANGLES, TUNNELS or COMPONENTS n: the last step such that neither it nor any step
   *   before it has more than n. (The number of tunnels can grow and fall again.) A target below
   *   C0's own number gives C0 and a warning.
   * - ERROR_BOUND e, a length: the first step such that no point of it, or of any step after it, is
   *   farther than e from M. These targets imply ComputeError. If no step is close enough, the last
   *   step and a warning.
   * - FEATURE_SIZE s, a length: the last step before a priority of at most s is popped (for VOLUME
   *   its cube root, for CIRCUMRADIUS twice its value), so that gaps wider than about s are open
   *   and narrower gaps are closed. This holds strictly only if DepthExponent and BreadthRadius are
   *   0 and CarveExposed is off.
   * - STEP k: that step, or the nearest one and a warning.
   */
  void AddLevelTarget(double target); ///< finite, at least 0; others are refused with an error
  void ClearLevelTargets();
  int GetNumberOfLevelTargets();
  /** The target of an index, or 0 if there is none. */
  double GetLevelTarget(int index);
  ///@}

  ///@{
  /**
   * The wall-clock seconds that each stage of the last update took, summed over the leaves of a
   * composite input. The first stages belong to the helper program; their seconds are 0 if its
   * result was reused. With several processors (NumberOfThreads), the helper programs of a
   * composite input run beside each other, so that the sum exceeds the time of the update; and
   * `resolve` is 0 where TetGen ran meanwhile. An index out of range gives 0 and null.
   */
  int GetNumberOfStages();
  const char* GetStageName(int stage);
  double GetStageSeconds(int stage);
  ///@}

  ///@{
  /**
   * The processes that share the work of a parallel run. The default is the global controller,
   * which exists under MPI only. Every object, which is the input or one of its leaves, is carved
   * whole by one process: the process that has the object, unless that would get over a tenth more
   * cells than its share. Its outputs stay there. If an object is spread over several processes,
   * one process gathers it, and a warning says so. The other processes get the same blocks with
   * null or empty data.
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
   * Whether the last update succeeded and had these inputs, as they are now, and the present
   * properties. In a parallel run, all processes must ask, and get the same answer.
   */
  bool IsUpToDate(vtkInformationVector** in);

  int InitialApproximation = CONVEX_HULL;
  int PriorityMeasure = AUTO_MEASURE;
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
  int Strategy = AUTO;
  double EnclosingTolerance = 0.02;
  double SnapTolerance = 1e-12;
  bool AppendInput = false;
  int OutputType = MULTIBLOCK;
  double TimeLimit = 0.0;
  double MemoryLimit = 0.0;
  int NumberOfLevels = 8;
  int KeepBothFoldSides = AUTO;
  bool ManifoldOutput = true;
  bool ComputeError = false;
  int LevelTargetType = VERTICES;
  int LevelSimplification = SUBSET;
  int NumberOfThreads = 0;
  bool ReuseDecomposition = true;
  int MaximumVertices = 0;
  std::vector<double> Targets;

private:
  vtkCarverAlgorithm(const vtkCarverAlgorithm&) = delete;
  void operator=(const vtkCarverAlgorithm&) = delete;

  struct Version;

  CarverSettings GetSettings();
  /** Sets a property to the number within the range; one that is not finite is an error. */
  void SetNumber(const char* name, double number, double greatest, double& property);

  int Dimension;
  bool WasAborted = false; ///< by the last update
  vtkMultiProcessController* Controller = nullptr;
  std::unique_ptr<CarverSessionBase> Session;
  std::unique_ptr<ObjectExchange> Exchange;
  std::unique_ptr<Version> Done; ///< by the last update, if it succeeded
};

#endif
