// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContourCarver
 * @brief simplify the topology of contours in a plane by carving them out of their convex hull
 *
 * The input is a vtkPolyData whose polygons and polylines, closed or open, crossing or not, lie in
 * any one plane, or a composite of such vtkPolyData. vtkContourCarver triangulates the plane
 * between these contours M and their convex hull C0. It then carves the triangles away, those with
 * the longest edge first, until M appears: the paper's method, which vtkTopologyCarver applies in
 * space, in the plane. One run gives a stream of contours C0, C1, ..., Cn = M in which components
 * split off and holes open one after the other.
 *
 * - input: vtkPolyData, the contours M
 * - output port 0: vtkMultiBlockDataSet, the levels "LOD 0" (coarsest), "LOD 1", ...
 * - output port 1: vtkUnstructuredGrid, the stream: triangles, edges, steps
 * - output port 2: vtkTable, the profile: a row per step, row 0 is C0
 *
 * The boundary of a polygon is a contour, whatever its direction. Vertices and strips are ignored,
 * with a note.
 *
 * **Levels** are vtkPolyData with a VTK_LINE cell per edge, in the input's plane. The solid is on
 * the left of each edge, as seen from the positive side of the coordinate axis that is closest to
 * the plane's normal. A fold, which is an edge of M with solid on neither side, shows once, as in
 * M. With ManifoldOutput, no vertex has more than two edges: parts that touch in a point are cut
 * apart there.
 *
 * Vertices are bit for bit those of the input. Points are equal if they agree in the two
 * coordinates other than that of the axis closest to the normal. Edges that cross or overlap are
 * split first. The points of these splits are new, and so are the corners of BOUNDING_BOX and the
 * vertices of CUSTOM. The box is a rectangle in the plane, along the two other axes.
 *
 * The arrays are those of vtkTopologyCarver, except that there is no `SurfaceGenus`. `Triangles` is
 * the number of edges, `Tunnels` the number of holes in K_i, `Voids` is 0, `Volume` is the area,
 * and `Strategy` says how the plane was triangulated. The stream has all triangles of C0; the
 * triangles of the solid have `Step` -1 and `Priority` NaN. vtkExtractCarvedLOD extracts any level
 * from the stream.
 *
 * **Helper program, composite input**: as for vtkTopologyCarver.
 *
 * **Errors** are reported through vtkErrorMacro, and the outputs are then empty: a point that is
 * not finite or farther from the common plane than one millionth of the contours' diagonal,
 * contours that lie on one line, a helper program that is missing, dies or gives up. The contour of
 * CUSTOM on input port 1 must be one simple polygon in the same plane, around the input.
 */
#ifndef vtkContourCarver_h
#define vtkContourCarver_h

#include "vtkCarverAlgorithm.h"
#include "vtkTopologyCarvingModule.h" // for export macro

class VTKTOPOLOGYCARVING_EXPORT vtkContourCarver : public vtkCarverAlgorithm
{
public:
  static vtkContourCarver* New();
  vtkTypeMacro(vtkContourCarver, vtkCarverAlgorithm);

protected:
  vtkContourCarver();
  ~vtkContourCarver() override;

private:
  vtkContourCarver(const vtkContourCarver&) = delete;
  void operator=(const vtkContourCarver&) = delete;
};

#endif
