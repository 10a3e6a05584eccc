// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The boundary of the union of all tetrahedra that M pierces.
 */
#ifndef carving_ExposedFaces_h
#define carving_ExposedFaces_h

#include "Helper/Enclosing/KeptDistances.h"
#include "Helper/Enclosing/PiercedMesh.h"
#include "Helper/Enclosing/SurfaceDistance.h"

#include <vector>

namespace carving::helper
{

/** The corners of face f of a cell. */
SurfaceDistance::Corners FacePoints(const PiercedMesh::Cell& cell, int f);

/** A bound on the distance from M of any point of a pierced cell. */
double LongestEdge(const PiercedMesh::Cell& cell);

/** Whether a face of a pierced cell bounds the union of all pierced cells. */
bool IsExposed(const PiercedMesh& mesh, const PiercedMesh::Cell& cell, int f);

/**
 * The pierced ones of some cells that have an exposed face that is not within `tolerance` of M.
 * Faces that are within it are remembered.
 */
std::vector<PiercedMesh::Cell> FindFar(const PiercedMesh& mesh,
  const std::vector<PiercedMesh::Cell>& cells, const SurfaceDistance& distance, double tolerance,
  int threads);

/**
 * The maximum is found by search, the others from samples that are a hundredth of `length` apart.
 * Faces that are parts of M are left out.
 */
KeptDistances MeasureKept(const PiercedMesh& mesh, const SurfaceDistance& distance,
  double negligible, double length, int threads);

} // namespace carving::helper

#endif
