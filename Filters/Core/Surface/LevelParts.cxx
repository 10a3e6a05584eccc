// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/LevelParts.h"

#include <algorithm>

namespace carving
{

void AppendParts(const StoredStream<3>& stream, const Level<3>& level, TriangleMesh& input)
{
  const std::vector<Point>& points = stream.Mesh.Surface.Points;
  const auto own = static_cast<int>(input.Points.size()); // those of M come first
  for (const FaceLife<3>& face : level.Faces)
  {
    const bool isDivided = std::any_of(
      face.Corners.begin(), face.Corners.end(), [own](int corner) { return corner >= own; });
    if (face.Constraint < 0 || !isDivided)
    {
      continue;
    }
    const auto first = static_cast<int>(input.Points.size());
    for (const int corner : face.Corners)
    {
      input.Points.push_back(points[corner]);
    }
    input.Triangles.push_back({ first, first + 1, first + 2 });
  }
}

} // namespace carving
