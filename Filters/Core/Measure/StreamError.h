// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The distance of every approximation of a stream from M. Not in the paper.
 */
#ifndef carving_StreamError_h
#define carving_StreamError_h

#include "Core/Mesh/Mesh.h"
#include "Core/Mesh/Progress.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/**
 * Per step, the one-sided Hausdorff distance from the approximation's surface to `mesh`, which is
 * M: the largest distance of any point of the surface from M. Never too small, and at most 1 % or a
 * millionth of M's diagonal too large. `conforming`: M is a union of faces (exact mode), whose
 * distance is then 0.
 *
 * The first upper bound of a face's distance follows from its size, since its corners are on M or
 * close to M. Branch and bound refines the bounds of those faces that may be the farthest: the
 * distance from one triangle of M is convex, so that its maximum over a piece is at a corner. A
 * heap sweeps over the steps, so that the bounds of a face serve all steps that show the face.
 * Returns false if `progress` asked to stop.
 */
template <int D>
bool ComputeErrors(const StoredStream<D>& stream, const ResolvedInput<D>& mesh, bool conforming,
  std::vector<double>& errors, const Progress& progress = {});

} // namespace carving

#endif
