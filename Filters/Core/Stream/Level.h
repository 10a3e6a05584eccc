// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One approximation of a stream, written out as a surface.
 */
#ifndef carving_Level_h
#define carving_Level_h

#include "Core/Stream/Faces.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/**
 * The faces of C_step, the boundary of the solid and the cells that are not yet carved, oriented
 * outward, and the folds. Corners are indices into the stream's points.
 */
template <int D>
struct Level
{
  int Step = 0;
  std::vector<FaceLife<D>> Faces;
};

/** C_step, 0 <= step <= stream.Order.LastStep(). */
template <int D>
Level<D> ExtractLevel(const StoredStream<D>& stream, int step);

/** C_step for each of several ascending steps, at hardly more than the expense of one. */
template <int D>
std::vector<Level<D>> ExtractLevels(const StoredStream<D>& stream, const std::vector<int>& steps);

} // namespace carving

#endif
