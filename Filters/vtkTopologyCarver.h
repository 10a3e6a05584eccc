// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTopologyCarver
 * @brief simplify the topology of a polygonal mesh by carving it out of its convex hull
 *
 * The input is any vtkPolyData, closed or open, manifold or not, connected or not, or a composite
 * of vtkPolyData. vtkTopologyCarver tetrahedralizes the space between the mesh M and its convex
 * hull C0. It then carves the tetrahedra away, those with the longest edge first, until M appears.
 * One run gives a stream of approximations C0, C1, ..., Cn = M in which components split off and
 * tunnels open one after the other. Each approximation encloses M, is part of the one before it,
 * does not cross itself and, except for points at which triangles of M cross, has vertices of M
 * only. (Conformity, SnapTolerance, InitialApproximation and LevelSimplification say where other
 * vertices come in.)
 *
 * - input: vtkPolyData, the mesh M
 * - output port 0: vtkMultiBlockDataSet, the levels "LOD 0" (coarsest), "LOD 1", ...
 * - output port 1: vtkUnstructuredGrid, the stream: tetrahedra, triangles, steps
 * - output port 2: vtkTable, the profile: a row per step, row 0 is C0
 *
 * Polygons of more than three corners are triangulated as by vtkTriangleFilter where it succeeds.
 * Polygons with holes or of more than 300 corners are triangulated by vtkContourTriangulator. Where
 * corners are not in one plane, other triangulations are other surfaces, which levels need not
 * enclose.
 *
 * The method is that of "Carving for topology simplification of polygonal meshes", which README.md
 * cites in full. Section and equation numbers in this documentation refer to that paper.
 *
 * **Steps.** A step is one pop from the queue of carvable tetrahedra, with all tetrahedra that are
 * carved along. Step 0 is C0; a stream of n steps has n + 1 approximations.
 *
 * **Levels** are approximations that are written out. They are oriented outward. A fold, which is a
 * triangle of M with solid on neither side, shows once, oriented as in M. Vertices are doubles and
 * bit for bit those of the input. Triangles of the input that cross each other are split first.
 * Only the points of these splits are new, and Steiner points in the carved space where the
 * tetrahedralization needs some. With LevelSimplification, levels are decimated, and have other new
 * vertices, too.
 *
 * Arrays of a level:
 * - cells: `Priority` and `Depth` (doubles: q(t) d(t)^-dp and d(t) of equation (2)) of the
 *   tetrahedron behind the face, NaN and 0 for a face of M; `vtkOriginalCellIds`, the input cell,
 *   -1 for a carved face; the input's cell data, 0 on carved faces; `MetShare`, only of the level
 *   that AppendInput appends: the share of the triangle's area that pierces no tetrahedron, 1 where
 *   the triangle is met exactly.
 * - points: the input's point data, exact on input points, and interpolated at the closest point of
 *   the input on new points; `vtkOriginalPointIds`, -1 for a new point; `SnapDistance`, only if
 *   snapping has moved points: the distance that the point was moved. A point that was moved is one
 *   of the `NewVertices`.
 * - field data, on how the level was made: `Step`; `Kind`, "carved", "simplified" (see
 *   LevelSimplification) or, for the level that AppendInput appends, "input"; `Strategy`, how the
 *   mesh was tetrahedralized (see below); `KeptDistance`, only of a mesh that is enclosed: the
 *   distance that the pierced tetrahedra reach from the mesh, to 5 %; `KeptDistance99` and
 *   `KeptDistanceMean`, likewise: the distance of all but a hundredth of their surface, parts of
 *   the mesh apart, and the mean over this surface; `MetShare`, likewise: the share of the mesh's
 *   area that pierces no tetrahedron, so that the last level consists of it there; `SnapDistance`,
 *   only of a snapped mesh: the largest distance that a point was moved, that a new one has from
 *   the triangle that it divides, or that another triangle of a flat part has from the given ones.
 * - field data, on size and topology: `Vertices`, `NewVertices`, `Triangles`; `FeatureSize`, the
 *   smallest priority popped up to this step, as a length, infinite for C0; `Components`, `Tunnels`
 *   and `Voids` of the closed complex K_i; `SurfaceComponents` and `SurfaceGenus` of the level's
 *   own surface; `Error`, the largest distance of the level from M, NaN if it has not been asked
 *   for (see ComputeError). The five numbers on topology are -1 for "input".
 *
 * The values of `Strategy` are "TetGen -pcY"; "TetGen -pcY, without interior" if triangles inside
 * the solid were left out, which the stream then lacks; "Delaunay, recovery" if TetGen failed or
 * was not needed and vertices may have been added off the triangles; "TetGen -pc" if vertices were
 * added on the triangles; "TetGen -pcY, snapped" if points were moved, and "TetGen -pc, snapped" if
 * both; and "Delaunay, enclosing". If TetGen succeeded with another order of the triangles,
 * ", order 1" or ", order 2" follows.
 *
 * **Topology.** K_i is the union of M, the solid and all tetrahedra that are not carved before or
 * at step i. It is a closed set. `Components` is the number of connected components of K_i, where a
 * single common point connects. `Voids` is the number of hollows that K_i encloses. `Tunnels` is
 * the first Betti number of K_i: the number of independent loops in K_i that nothing fills.
 * Components and voids never get fewer along a stream; tunnels may merge. The Betti numbers are not
 * in the paper. The surface of a level is the result of cutting K_i's boundary (see
 * ManifoldOutput): where parts of K_i touch in single points or edges only, the surface has more
 * components and fewer handles than K_i, and each wall of a void is a component, too.
 * `SurfaceGenus` is the sum over the components and at most `Tunnels`; -1 if the surface is open or
 * has not been cut. Filters/TOPOLOGY.md explains all of this.
 *
 * Arrays of the stream, whose cells are the tetrahedra between M and C0, followed by the triangles
 * of M:
 * - cells: `Priority` (when popped); `Depth`; `Step`, for a tetrahedron the step that carves it, so
 *   that C_j lacks the tetrahedron for all j >= Step, for a triangle the first step at which it
 *   shows, and for either -1 if there is no such step; `Region`, the same number for tetrahedra
 *   that are connected by faces that are not of M, -1 for triangles; `SolidSides`, for a triangle 1
 *   if the solid is behind it plus 2 if the solid is in front of it; `vtkOriginalCellIds` and the
 *   input's cell data as above.
 * - points: `vtkOriginalPointIds` and the input's point data as above.
 * - field data: the settings under the names of the properties, and the columns of the profile
 *   under their names after "Profile": `ProfileVertices` and so on (`ProfileError` only if errors
 *   have been computed); `TargetRanges`: per target of vtkExtractCarvedLOD's LevelTargetType the
 *   least and the greatest that select different levels, and the least with simplified levels. In
 *   parallel, the processes without the stream have an empty grid with this array.
 *
 * With simplified levels, the stream also has their new points, after all others, and field data:
 * - `SimplifiedSteps`: per decimated step the step, the numbers of vertices, triangles and
 *   collapses, and the numbers of tuples that the step has in the next two arrays;
 * - `SimplifiedPoints`: per point of a decimated step the point of the stream, first for the
 *   vertices of the step, where a point has several if the surface is cut there, then for new ones;
 * - `SimplifiedFaces`: per triangle its corners (indices into the step's part of the points), the
 *   cell of the stream with its data, its birth and its death: it shows after birth <= j < death
 *   collapses;
 * - `SimplifiedLevels`: per level the index of the decimated step, the number of collapses, the
 *   distance from M, the last step that it could come from and the target, which is a number of
 *   vertices (`SimplifiedType` 0), triangles (1) or an error bound (5).
 *
 * vtkExtractCarvedLOD extracts any level from the stream.
 *
 * In enclosing mode (see Conformity), which is not in the paper, M need not be a union of faces.
 * The triangles of M in the stream and on levels are then those faces that overlap a triangle of M
 * in an area. The stream has all tetrahedra: the tetrahedra of the solid, and those that M pierces,
 * have `Step` -1 and `Priority` NaN.
 *
 * Columns of the profile: `Step`, `Vertices`, `Triangles`, `Components`, `Tunnels` and `Voids` of
 * K_i, `Priority` (popped at that step), `Volume` (of K_i; never grows), `Error` (NaN unless asked
 * for).
 *
 * The field data of port 0 has a string array `Notes` if there is something that the user should
 * know.
 *
 * Arrays of the input's cell and point data that have one of the above names are renamed: they get
 * "Input" in front of the name, and a note tells so. Field data with one of these names, which an
 * older carving may have left, is dropped. All other arrays are passed on to the three outputs.
 *
 * **Helper program.** CGAL and TetGen run in a child process, carving-helper, so that no mesh can
 * crash this process, and an abort takes effect at once. The program is found next to the library,
 * where it was installed, or through the environment variable TOPOLOGYCARVING_HELPER. Its result is
 * kept. The program runs again only after a change that could affect the result:
 * - the mesh, InitialApproximation, or for CUSTOM the mesh on port 1;
 * - Conformity, except from AUTO to EXACT if the mesh was neither snapped nor only enclosed, and no
 *   attempt reached a limit;
 * - Strategy;
 * - EnclosingTolerance, if the mesh is only enclosed;
 * - SnapTolerance, if the mesh was snapped or only enclosed;
 * - SolidRule, if the first attempts failed, or M has cracks;
 * - TimeLimit or MemoryLimit, except if raised where no attempt reached a limit.
 *
 * **Composite input**: the outputs are vtkMultiBlockDataSets with the tree and the names of the
 * input. Each leaf is replaced by its levels (port 0: a block of blocks), its stream and its
 * profile. Helper programs decompose several leaves at a time (see NumberOfThreads).
 *
 * **Errors** are reported through vtkErrorMacro, and the outputs are then empty: an input that is
 * not polygonal, a point that is not finite or has a coordinate above 1e38, a cell with a point
 * that does not exist, a mesh that lies in one plane, a helper program that is missing, dies, gives
 * up or reaches a limit. README.md lists all messages.
 */
#ifndef vtkTopologyCarver_h
#define vtkTopologyCarver_h

#include "vtkCarverAlgorithm.h"
#include "vtkTopologyCarvingModule.h" // for export macro

class vtkPolyData;

class VTKTOPOLOGYCARVING_EXPORT vtkTopologyCarver : public vtkCarverAlgorithm
{
public:
  static vtkTopologyCarver* New();
  vtkTypeMacro(vtkTopologyCarver, vtkCarverAlgorithm);

  /**
   * Counts the pairs of triangles of a mesh that cross or overlap each other after equal points
   * have been merged. Counting ends at 10 million pairs. The helper program does the work. Returns
   * -1 after an error, which is reported, such as that no triangle has an area. The properties,
   * inputs and outputs of the filter play no part.
   */
  int CountIntersectingPairs(vtkPolyData* mesh);

protected:
  vtkTopologyCarver();
  ~vtkTopologyCarver() override;

private:
  vtkTopologyCarver(const vtkTopologyCarver&) = delete;
  void operator=(const vtkTopologyCarver&) = delete;
};

#endif
