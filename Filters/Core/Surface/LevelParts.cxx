// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/LevelParts.h"

#include <algorithm>

namespace carving
{

TriangleMesh ExtractParts(
  const StoredStream<3>& stream, const Level<3>& level, std::size_t numberOfPoints)
{
  TriangleMesh parts;
  const std::vector<Point>& points = stream.Mesh.Surface.Points;
  const auto own = static_cast<int>(numberOfPoints); // M's come first
  for (const FaceLife<3>& face : level.Faces)
  {
    const bool isDivided = std::any_of(
      face.Corners.begin(), face.Corners.end(), [own](int corner) { return corner >= own; });
    if (face.Constraint < 0 || !isDivided)
    {
      continue;
    }
    const auto first = static_cast<int>(parts.Points.size());
    for (const int corner : face.Corners)
    {
      parts.Points.push_back(points[corner]);
    }
    parts.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return parts;
}

} // namespace carving
