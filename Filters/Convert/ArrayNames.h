// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The names of all arrays that the carvers write. vtkTopologyCarver.h documents the arrays.
 */
#ifndef ArrayNames_h
#define ArrayNames_h

/** Arrays of the stream. The first ones also belong to levels. */
namespace StreamArrays
{
constexpr const char* Priority = "Priority";
constexpr const char* Depth = "Depth";
constexpr const char* Step = "Step"; ///< also in the field data of a level and in the profile
constexpr const char* OriginalCells = "vtkOriginalCellIds";
constexpr const char* OriginalPoints = "vtkOriginalPointIds";
constexpr const char* Strategy = "Strategy";
constexpr const char* KeptDistance = "KeptDistance";
constexpr const char* KeptDistance99 = "KeptDistance99";
constexpr const char* KeptDistanceMean = "KeptDistanceMean";
constexpr const char* MetShare = "MetShare";
constexpr const char* SnapDistance = "SnapDistance"; ///< of the mesh, and per point
constexpr const char* Region = "Region";
constexpr const char* SolidSides = "SolidSides";
constexpr const char* Measure = "PriorityMeasure";
constexpr const char* BothFoldSides = "KeepBothFoldSides";
constexpr const char* ProfileVertices = "ProfileVertices";
constexpr const char* ProfileTriangles = "ProfileTriangles";
constexpr const char* ProfileError = "ProfileError"; ///< only if errors have been computed
constexpr const char* ProfileVolume = "ProfileVolume";
constexpr const char* ProfileComponents = "ProfileComponents";
constexpr const char* ProfileTunnels = "ProfileTunnels";
constexpr const char* ProfileVoids = "ProfileVoids";
constexpr const char* ProfilePriority = "ProfilePriority";
constexpr const char* TargetRanges = "TargetRanges";
// Only if levels have been simplified.
constexpr const char* SimplifiedType = "SimplifiedType";
constexpr const char* SimplifiedSteps = "SimplifiedSteps";
constexpr const char* SimplifiedPoints = "SimplifiedPoints";
constexpr const char* SimplifiedFaces = "SimplifiedFaces";
constexpr const char* SimplifiedLevels = "SimplifiedLevels";
} // namespace StreamArrays

/** Field data of a level. */
namespace LevelArrays
{
constexpr const char* Vertices = "Vertices";
constexpr const char* NewVertices = "NewVertices";
constexpr const char* Triangles = "Triangles";
constexpr const char* Kind = "Kind";
constexpr const char* FeatureSize = "FeatureSize";
constexpr const char* Error = "Error";
constexpr const char* Components = "Components";
constexpr const char* Tunnels = "Tunnels";
constexpr const char* Voids = "Voids";
constexpr const char* SurfaceComponents = "SurfaceComponents";
constexpr const char* SurfaceGenus = "SurfaceGenus";
} // namespace LevelArrays

/** Columns of the profile; the others are called as in LevelArrays. */
namespace ProfileArrays
{
constexpr const char* Priority = "Priority";
constexpr const char* Volume = "Volume";
} // namespace ProfileArrays

/** Field data of port 0. */
constexpr const char* NotesArray = "Notes";

#endif
