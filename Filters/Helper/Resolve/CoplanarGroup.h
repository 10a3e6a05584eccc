// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Triangles of one plane, cut along each other and along what crosses the plane.
 */
#ifndef carving_CoplanarGroup_h
#define carving_CoplanarGroup_h

#include "Helper/Resolve/CutPoints.h"

#include <vector>

/** Triangles in one plane, ascending, and what others have in common with them. */
struct CoplanarGroup
{
  std::vector<int> Triangles;
  std::vector<std::array<int, 2>> Cuts; ///< segments between points; isolated ones have equal ends
};

/**
 * Appends the faces of the group's arrangement that any of its triangles covers to `result`, which has the
 * points of `mesh` and `cutPoints`. All triangles that cover a face are merged into it, as if it had been
 * appended for each of them: it is of the first, and has the signed sum and the sum of their numbers. New
 * points are exact, then rounded. Takes O((n + k) log n) time for n edges and cuts with k
 * intersections, besides the time to name all triangles that cover each face.
 */
void AppendPieces(const carving::ResolvedMesh& mesh, const CutPoints& cutPoints,
  const CoplanarGroup& group, carving::ResolvedMesh& result);

#endif
