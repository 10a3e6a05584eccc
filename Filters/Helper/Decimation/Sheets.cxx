// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/Sheets.h"

#include "Helper/Base/ExactWinding.h"
#include "Helper/Resolve/Clean.h"

#include <algorithm>
#include <utility>

namespace carving::helper
{
namespace
{

/** The corners in ascending order, and the face. */
using FaceWithCorners = std::pair<std::array<Point, 3>, Face>;

} // namespace

std::vector<char> FindSheets(const SurfaceMesh& surface)
{
  std::vector<char> isSheet(surface.num_faces(), 0);
  std::vector<FaceWithCorners> faces;
  faces.reserve(isSheet.size());
  for (const Face face : surface.faces())
  {
    faces.emplace_back(CornersOf(surface, face), face);
    std::sort(faces.back().first.begin(), faces.back().first.end());
  }
  std::sort(faces.begin(), faces.end());
  const auto haveSameCorners = [](const FaceWithCorners& a, const FaceWithCorners& b)
  { return a.first == b.first; };
  auto first = std::adjacent_find(faces.begin(), faces.end(), haveSameCorners);
  if (first == faces.end())
  {
    return isSheet;
  }
  const ResolvedMesh mesh = AsResolved(AsTriangleMesh(surface));
  const ExactWinding winding(mesh);
  // Only its opposite may cover a face.
  const auto isExteriorInFront = [&](const FaceWithCorners& face)
  { return winding.InFrontOf(static_cast<int>(face.second)) == 0; };
  while (first != faces.end())
  {
    const auto last = std::find_if(first, faces.end(),
      [&](const FaceWithCorners& face) { return !haveSameCorners(face, *first); });
    if (last - first == 2 && std::all_of(first, last, isExteriorInFront))
    {
      isSheet[first[0].second] = isSheet[first[1].second] = 1;
    }
    first = std::adjacent_find(last, faces.end(), haveSameCorners);
  }
  return isSheet;
}

} // namespace carving::helper
