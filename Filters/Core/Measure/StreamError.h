// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How far every approximation of a stream is from M.
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
 * Per step, how far the point of that approximation's surface that is farthest from `mesh`, which is M, is
 * from it: the one-sided Hausdorff distance. Never too small, and at most one hundredth (of it) too large.
 * `conforming`: M is a union of faces (exact mode), which are then at no distance.
 *
 * A face is bounded first by its size, as corners are on M or nearly so; only where that decides which face
 * is the farthest, by branch and bound: the distance from one triangle of M is convex, so that it is greatest
 * in a corner of each piece. What is found of a face serves all steps that show it: a heap sweeps over
 * them. Returns false when `progress` asked to stop.
 */
template <int D>
bool ComputeErrors(const StoredStream<D>& stream, const ResolvedInput<D>& mesh, bool conforming,
  std::vector<double>& errors, const Progress& progress = {});

} // namespace carving

#endif
