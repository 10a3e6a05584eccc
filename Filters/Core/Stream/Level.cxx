// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stream/Level.h"

#include "Core/Mesh/LargePages.h"

#include <algorithm>

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

template <int D>
std::vector<Level<D>> ExtractLevels(const StoredStream<D>& stream, const std::vector<int>& steps,
  const std::vector<int>& numbersOfFaces)
{
  std::vector<Level<D>> levels(steps.size());
  if (steps.empty())
  {
    return levels;
  }
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    levels[i].Step = steps[i];
    if (!numbersOfFaces.empty())
    {
      ReserveLarge(levels[i].Faces, numbersOfFaces[steps[i]]);
    }
  }
  const auto addWhereItShows = [&](const FaceLife<D>& face)
  {
    auto step = std::lower_bound(steps.begin(), steps.end(), face.Birth);
    for (; step != steps.end() && *step < face.Death; ++step)
    {
      levels[step - steps.begin()].Faces.push_back(face);
    }
  };
  ForEachFace(stream, addWhereItShows, steps.front(), steps.back());
  return levels;
}

template Level<2> ExtractLevel<2>(const StoredStream<2>&, int);
template Level<3> ExtractLevel<3>(const StoredStream<3>&, int);
template std::vector<Level<2>> ExtractLevels<2>(
  const StoredStream<2>&, const std::vector<int>&, const std::vector<int>&);
template std::vector<Level<3>> ExtractLevels<3>(
  const StoredStream<3>&, const std::vector<int>&, const std::vector<int>&);

} // namespace carving
