// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The surface of one approximation of a stream.
 */
#ifndef carving_Level_h
#define carving_Level_h

#include "Core/Stream/Faces.h"
#include "Core/Stream/StoredStream.h"

#include <vector>

namespace carving
{

/**
 * The faces of C_step, oriented outward: the boundary of the solid and the remaining cells, and the
 * folds. Corners are indices into the stream's points.
 */
template <int D>
struct Level
{
  int Step = 0;
  std::vector<FaceLife<D>> Faces;
};

/** C_step, where 0 <= step <= stream.Order.LastStep(). */
template <int D>
Level<D> ExtractLevel(const StoredStream<D>& stream, int step);

/**
 * C_step for several ascending steps, in one pass over the faces. `numbersOfFaces` has the number
 * of each step, as the profile does, for which memory is reserved; it may be empty.
 */
template <int D>
std::vector<Level<D>> ExtractLevels(const StoredStream<D>& stream, const std::vector<int>& steps,
  const std::vector<int>& numbersOfFaces = {});

} // namespace carving

#endif
