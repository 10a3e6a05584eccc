// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a stored stream to the data objects of the ports 1 and 2. The filters' headers document their
 * arrays.
 */
#ifndef StreamOutput_h
#define StreamOutput_h

#include "Core/Measure/Profile.h"
#include "Core/Stream/StoredStream.h"
#include "vtkType.h"

#include <vector>

class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

/** Names of the arrays that carry a stream from StreamOutput to StreamInput and LevelOutput. */
namespace StreamArrays
{
constexpr const char* Priority = "Priority";
constexpr const char* Depth = "Depth";
constexpr const char* Step = "Step";
constexpr const char* Region = "Region";
constexpr const char* SolidSides = "SolidSides";
constexpr const char* OriginalCells = "vtkOriginalCellIds";
constexpr const char* OriginalPoints = "vtkOriginalPointIds";
constexpr const char* Measure = "PriorityMeasure";
constexpr const char* BothFoldSides = "KeepBothFoldSides";
constexpr const char* Strategy = "Strategy";
constexpr const char* KeptDistance = "KeptDistance";
constexpr const char* SnapDistance = "SnapDistance"; ///< of the mesh and, per point, its own
constexpr const char* ProfileVertices = "ProfileVertices";
constexpr const char* ProfileTriangles = "ProfileTriangles";
constexpr const char* ProfileError = "ProfileError"; ///< only if it has been computed
constexpr const char* ProfileVolume = "ProfileVolume";
constexpr const char* ProfileComponents = "ProfileComponents";
constexpr const char* ProfileTunnels = "ProfileTunnels";
constexpr const char* ProfileVoids = "ProfileVoids";
constexpr const char* ProfilePriority = "ProfilePriority";
} // namespace StreamArrays

/**
 * `cellIds` has the cell of `input` for every facet that the helper program was given. The field data
 * gets the profile and what the stream says of itself; the caller adds the other settings.
 */
template <int D>
void FillStream(const carving::StoredStream<D>& stream, const carving::Profile& profile,
  vtkPolyData* input, const std::vector<vtkIdType>& cellIds, vtkUnstructuredGrid* output);

void FillProfile(const carving::Profile& profile, vtkTable* output);

#endif
