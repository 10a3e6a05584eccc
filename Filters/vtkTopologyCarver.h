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
 *   closest point of the input; `vtkOriginalPointIds`, -1 for a new point; of a snapped mesh
 *   `SnapDistance`, by how much the point was moved, which makes it one of `NewVertices` if not 0.
 * - field data: `Step`, `Vertices`, `NewVertices`, `Triangles`, `Kind` ("carved", or
 *   "input" for the level that AppendInput appends), `Strategy` (how the
 *   mesh was tetrahedralized: "TetGen -pcY", "TetGen -pcY, order 1" and so on, "TetGen -pcY, without
 *   interior" where triangles inside the solid were left out, which the stream then lacks, "TetGen -pcM" where vertices
 *   were added on its triangles, "TetGen -pcY, snapped" where its points were moved, "Delaunay, enclosing"),
 *   `KeptDistance` (only of a mesh that is enclosed: how far what stays of the pierced tetrahedra reaches
 *   from it, to 5 %), `SnapDistance` (only of a mesh that has been snapped, see SnapTolerance: the farthest
 *   that a point was moved by, a length), `FeatureSize` (the smallest priority popped up to this step, a length;
 *   infinite for C0); `Components`, `Tunnels` and `Voids` of the closed complex K_i, and
 *   `SurfaceComponents` and `SurfaceGenus` of the level's own surface, all -1 for "input"; `Error`, how
 *   far it is from M at most, NaN where that has not been asked for (see ComputeError).
 *
 * **Topology.** K_i is M with the solid and all tetrahedra that are not carved away until step i, a closed
 * set. Its `Components` are what hangs together, be it by one point; its `Voids` are the hollows that it
 * encloses; its `Tunnels` is its tunnels, the first Betti number: the loops in it that nothing fills, each
 * independent of the others. Components and voids never get fewer; tunnels may merge. The surface is what
 * cutting leaves (see ManifoldOutput): where pieces of K_i touch in single points or edges only, it has more
 * components and fewer handles, and each wall of a void is a component too. `SurfaceGenus` is the sum over
 * its components, and at most `Tunnels`; -1 where it is open, or has not been cut. Filters/TOPOLOGY.md
 * explains all of this.
 *
 * Arrays of the stream, whose cells are the tetrahedra between M and C0 and then the triangles of M:
 * `Priority` (when popped), `Depth`, `Step` (of a tetrahedron: it is missing from C_j for j >= Step;
 * of a triangle: the first step at which it shows; -1: never), `Region` (tetrahedra joined by faces
 * that are not of M; -1 for triangles) and `SolidSides` (of a triangle: 1 if the solid is behind it plus 2
 * if it is in front), `vtkOriginalCellIds`, `vtkOriginalPointIds` and the input's data as above. Its
 * field data has the settings by the names of the properties, and the profile by the names of its columns
 * after "Profile": `ProfileVertices` and so on (`ProfileError` only if it has been asked for).
 * vtkExtractCarvedLOD gives any level from it.
 *
 * In enclosing mode (see Conformity) M need not be a union of faces. The triangles of M in the stream and
 * on levels are then those faces that overlap one of M's in an area, and the stream has all tetrahedra:
 * those of the solid, and those that M pierces, have `Step` -1 and `Priority` NaN.
 *
 * Columns of the profile: `Step`, `Vertices`, `Triangles`, `Components`, `Tunnels` and `Voids` of K_i,
 * `Priority` (popped at that step), `Volume` (of K_i; never grows), `Error` (NaN unless asked for).
 *
 * The field data of port 0 has a string array `Notes` if there is something the user should know.
 *
 * Of the input's own arrays, those in cell and point data that have a name of the above are passed on under
 * another one, "Input" before it, which a note tells. Field data of such names, which an older carving may
 * have left, is dropped; all else is passed on to the three outputs.
 *
 * **Helper program.** CGAL and TetGen run in a child process, carving-helper, so that no mesh can
 * take this process down and an abort takes effect at once. It is found next to the library or where
 * it was installed, or through the environment variable TOPOLOGYCARVING_HELPER. Its result is kept. It
 * runs again only where that could differ:
 * - the mesh, InitialApproximation, or for CUSTOM the mesh on port 1 has changed;
 * - Conformity has, except from AUTO to EXACT for a mesh that was met, no attempt having reached a limit;
 * - EnclosingTolerance has, for a mesh that is enclosed only;
 * - SnapTolerance has, for a mesh that was snapped, or that AUTO has enclosed only;
 * - SolidRule has, for a mesh of which the first attempts failed;
 * - TimeLimit or MemoryLimit has, except raised where no attempt had reached a limit.
 *
 * **Composite input**: the outputs are vtkMultiBlockDataSets with the tree and the names of the
 * input, in which the leaves are replaced by the levels (port 0: a block of blocks), the stream and
 * the profile of each.
 *
 * **Errors** are reported through vtkErrorMacro, and the outputs are then empty: input that is not
 * polygonal, a point that is not finite or has a coordinate above 1e38, a cell with a point that there is
 * not, a mesh that lies in one plane, a helper program that is missing, dies, gives up or reaches a limit.
 * README.md lists all messages.
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
   * Counts the pairs of triangles of a mesh that cross or overlap each other, after points that are equal have
   * been merged. The helper program does the work. Returns -1 after an error, which is reported. The
   * properties, inputs and outputs of the filter play no part.
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
