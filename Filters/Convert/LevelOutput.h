// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a stored stream to a level as polygonal data. vtkTopologyCarver.h documents the arrays.
 */
#ifndef LevelOutput_h
#define LevelOutput_h

#include "Core/Measure/Profile.h"
#include "Core/Measure/SimplifiedStream.h"
#include "Core/Stream/Level.h"
#include "Core/Stream/StoredStream.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

/**
 * Fills a level. `grid` is the stream as FillStream has written it; the attributes come from there.
 */
template <int D>
void FillLevel(const carving::StoredStream<D>& stream, const carving::Profile& profile,
  vtkUnstructuredGrid* grid, const carving::Level<D>& level, bool manifold, vtkPolyData* output);

/**
 * Fills the level for a target: the simplified one that is selected, the step of the carving that
 * meets the target as it is, or, if there is no simplified level, the step that comes closest.
 * Triangles have the attributes of the faces that they have been. Returns an empty string, or a
 * sentence that says why the target is not met.
 */
std::string FillSimplifiedLevel(const carving::StoredStream<3>& stream,
  const carving::SimplifiedStream& simplified, const carving::Profile& profile,
  vtkUnstructuredGrid* grid, const carving::SimplifiedTarget& target, bool manifold,
  vtkPolyData* output);

/**
 * Fills a level with M as given, for a mesh that is only enclosed. `cellIds` has the cell of
 * `input` for each triangle that the helper program was given.
 */
void FillInputLevel(const carving::Tetrahedralization& result, const carving::Profile& profile,
  vtkPolyData* input, const std::vector<vtkIdType>& cellIds, vtkUnstructuredGrid* grid,
  vtkPolyData* output);

#endif
