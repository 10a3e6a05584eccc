// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContourCarver
 * @brief simplify the topology of contours in a plane by carving them out of their convex hull
 *
 * Input is a vtkPolyData whose polygons and polylines, closed or open, crossing or not, lie in one
 * plane, whichever it is, or a composite of such. vtkContourCarver triangulates the plane between these
 * contours M and their convex hull C0 and carves the triangles away, those with the longest edge first,
 * until M appears: vtkTopologyCarver in the plane, of the same paper. One run gives a stream of contours
 * C0, C1, ..., Cn = M, of which pieces split off and whose holes open one after the other.
 *
 *                    +--> port 0: vtkMultiBlockDataSet, the levels "LOD 0" (coarsest), "LOD 1", ...
 *   vtkPolyData M ---+--> port 1: vtkUnstructuredGrid, the stream: triangles, edges, steps
 *                    +--> port 2: vtkTable, the profile: a row per step, row 0 is C0
 *
 * Of a polygon the boundary counts, whichever way it runs; vertices and strips are passed over, with a
 * note.
 *
 * **Levels** are vtkPolyData with a VTK_LINE cell per edge, in the input's plane. Edges run so that the
 * solid is on their left as seen from the positive side of the coordinate axis that is closest to the
 * plane's normal. An edge of M with solid on neither side, a fold, shows once, as in M. With
 * ManifoldOutput no vertex has more than two edges.
 *
 * Vertices are bit for bit those of the input. Points are equal if they are in the two coordinates that
 * are left without the axis closest to the normal. Where edges cross or overlap they are split first;
 * the points made by that are new, and so are the corners of BOUNDING_BOX and the vertices of CUSTOM. The
 * box is a rectangle in the plane, along the two axes that are left.
 *
 * The arrays are those of vtkTopologyCarver but for `SurfaceGenus`; `Triangles` is the number of edges,
 * `Tunnels` that of holes in K_i, `Voids` is 0, `Volume` the area, and `Strategy` says how the plane was
 * triangulated. The stream has all triangles of C0; those of the solid have `Step` -1 and `Priority` NaN. With
 * ManifoldOutput, what touches in a point is cut apart there.
 * vtkExtractCarvedLOD gives any level from the stream.
 *
 * **Helper program, composite input**: as for vtkTopologyCarver.
 *
 * **Errors** are reported through vtkErrorMacro, and the outputs are then empty: a point that is not
 * finite or farther from the common plane than one millionth of the contours' diagonal, contours that
 * lie on one line, a helper program that is missing, dies or gives up. CUSTOM's contour on input port
 * 1 has to be one simple polygon in the same plane, around the input.
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
