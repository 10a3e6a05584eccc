// SPDX-License-Identifier: BSD-3-Clause
#include "Level.h"

namespace carving
{

template <int D>
Level<D> ExtractLevel(const StoredStream<D>& stream, int step)
{
  Level<D> level;
  level.Step = step;
  ForEachFace(
    stream, [&](const FaceLife<D>& face) { level.Faces.push_back(face); }, step, step);
  return level;
}

template Level<2> ExtractLevel<2>(const StoredStream<2>&, int);
template Level<3> ExtractLevel<3>(const StoredStream<3>&, int);

} // namespace carving
