// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * Resolves the triangles of one plane: cuts them along each other and along triangles of other
 * planes.
 */
#ifndef carving_CoplanarGroup_h
#define carving_CoplanarGroup_h

#include "Helper/Resolve/CutPoints.h"

#include <vector>

namespace carving::helper
{

/** A side of a triangle, or a part of one, from one point to another. */
struct Side
{
  int From, To;
  int Triangle;
};

/** Whether two triangles lie in one plane. Exact. */
bool AreCoplanar(const ResolvedMesh& mesh, int a, int b);

/** Adds the three sides of a triangle. */
void AppendSides(const ResolvedMesh& mesh, int triangle, std::vector<Side>& sides);

/**
 * Triangles in one plane, in ascending order, their sides or all parts of these, and their
 * intersections with triangles of other planes.
 */
struct CoplanarGroup
{
  std::vector<int> Triangles;
  std::vector<Side> Sides;
  std::vector<std::array<int, 2>> Cuts; ///< segments between points; equal ends: a single point
};

/**
 * Appends the faces of the group's arrangement that any triangle covers to `result`, which has the
 * points of `mesh` and `cutPoints`. All triangles that cover a face are merged into it: the face
 * belongs to the first of them, and its multiplicities are the sums of theirs. New points are
 * exact, then rounded. Takes O((n + k) log n) time for n edges and cuts with k intersections, plus
 * the time to list the triangles that cover each face.
 */
void AppendPieces(const ResolvedMesh& mesh, const CutPoints& cutPoints, const CoplanarGroup& group,
  ResolvedMesh& result);

} // namespace carving::helper

#endif
