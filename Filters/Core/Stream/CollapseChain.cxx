// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stream/CollapseChain.h"

#include <algorithm>

namespace carving
{

CollapsedSurface ExtractSurface(const CollapseChain& chain, int collapses)
{
  CollapsedSurface surface;
  for (const ChainFace& face : chain.Faces)
  {
    if (face.Birth <= collapses && collapses < face.Death)
    {
      surface.Triangles.push_back(face.Corners);
      surface.Sources.push_back(face.Source);
      surface.Points.insert(surface.Points.end(), face.Corners.begin(), face.Corners.end());
    }
  }
  std::vector<int>& points = surface.Points;
  if (points.empty())
  {
    return surface;
  }
  std::vector<int> newIndex(*std::max_element(points.begin(), points.end()) + 1, -1);
  for (const int point : points)
  {
    newIndex[point] = 0;
  }
  points.clear();
  for (std::size_t point = 0; point < newIndex.size(); ++point)
  {
    if (newIndex[point] == 0)
    {
      newIndex[point] = static_cast<int>(points.size());
      points.push_back(static_cast<int>(point));
    }
  }
  for (Triangle& t : surface.Triangles)
  {
    for (int& corner : t)
    {
      corner = newIndex[corner];
    }
  }
  return surface;
}

std::string FindMistake(const CollapseChain& chain, std::size_t points)
{
  if (chain.Vertices < 0 || chain.Collapses < 0 || chain.Collapses > chain.Vertices ||
    chain.Triangles < 2LL * chain.Collapses ||
    static_cast<std::size_t>(chain.Triangles) > chain.Faces.size())
  {
    return "the numbers of vertices, triangles and collapses of a chain contradict each other";
  }
  std::vector<long long> change(chain.Collapses + 2, 0); // of the number of faces, by each collapse
  for (std::size_t i = 0; i < chain.Faces.size(); ++i)
  {
    const ChainFace& face = chain.Faces[i];
    const auto& [a, b, c] = face.Corners;
    const bool good = a != b && b != c && c != a && 0 <= face.Birth && face.Birth < face.Death &&
      face.Death <= chain.Collapses + 1 && face.Source >= 0 &&
      std::all_of(face.Corners.begin(), face.Corners.end(),
        [&](int corner) { return corner >= 0 && static_cast<std::size_t>(corner) < points; });
    if (!good)
    {
      return "face " + std::to_string(i) + " of a chain has a number out of range";
    }
    ++change[face.Birth];
    --change[face.Death];
  }
  long long count = 0;
  for (int collapses = 0; collapses <= chain.Collapses; ++collapses)
  {
    count += change[collapses];
    if (count != chain.Triangles - 2LL * collapses)
    {
      return "a chain has " + std::to_string(count) + " triangles after " +
        std::to_string(collapses) + " collapses";
    }
  }
  return {};
}

} // namespace carving
