// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a stored stream to a level as polygonal data. vtkTopologyCarver.h documents the arrays.
 */
#ifndef LevelOutput_h
#define LevelOutput_h

#include "Core/Measure/Profile.h"
#include "Core/Stream/Level.h"
#include "Core/Stream/StoredStream.h"
#include "vtkType.h"

#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

/**
 * Fills a level. `grid` is the stream as FillStream has written it; the attributes come from there.
 */
template <int D>
void FillLevel(const carving::StoredStream<D>& stream, const carving::Profile& profile,
  vtkUnstructuredGrid* grid, const carving::Level<D>& level, bool manifold, vtkPolyData* output);

/** A level of which edges have been collapsed. */
struct SimplifiedLevel
{
  int Step = 0;
  carving::TriangleMesh Mesh;
  std::vector<int> Points;                 ///< per vertex: the point of the stream, or -1
  std::vector<carving::FaceLife<3>> Faces; ///< per triangle: the face that it has been
  double Error = 0.0;                      ///< the distance from M
};

/**
 * Fills a simplified level. Triangles have the attributes of the faces that they have been, and new vertices those of the
 * closest point of `input`, the input with its usable attributes.
 */
void FillSimplifiedLevel(const carving::StoredStream<3>& stream, const carving::Profile& profile,
  vtkPolyData* input, vtkUnstructuredGrid* grid, const SimplifiedLevel& level, vtkPolyData* output);

/**
 * Fills a level with M as given, for a mesh that is only enclosed. `cellIds` has the cell of
 * `input` for each triangle that the helper program was given.
 */
void FillInputLevel(const carving::ResolvedMesh& mesh, const carving::Profile& profile,
  vtkPolyData* input, const std::vector<vtkIdType>& cellIds, vtkUnstructuredGrid* grid,
  vtkPolyData* output);

#endif
