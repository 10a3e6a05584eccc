// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/FindConstraints.h"

#include "Core/Mesh/Buckets.h"

#include <algorithm>
#include <cstdint>

namespace carving::helper
{
namespace
{

/** A face or a triangle of M: its least corner, and the others, ascending, as one number. */
struct FaceKey
{
  int Least;
  std::uint64_t Others;

  explicit FaceKey(Triangle t)
  {
    std::sort(t.begin(), t.end());
    this->Least = t[0];
    this->Others = static_cast<std::uint64_t>(t[1]) << 32 | static_cast<std::uint64_t>(t[2]);
  }
};

/** A triangle of M in the bucket of its least corner. */
struct SortedFacet
{
  std::uint64_t Others;
  int Index;

  bool operator<(const SortedFacet& other) const
  {
    return this->Others < other.Others;
  }
};

/** The face of a cell that it shares with a neighbor. */
int FaceTowards(const Tetrahedralization& mesh, int cell, int neighbor)
{
  const auto& neighbors = mesh.Neighbors[cell];
  const auto found = std::find(neighbors.begin(), neighbors.end(), neighbor);
  return static_cast<int>(found - neighbors.begin()) % 4; // % for neighbors that are not mutual
}

} // namespace

std::size_t FindConstraints(Tetrahedralization& result)
{
  const std::vector<Triangle>& triangles = result.Surface.Facets;
  // Cells are in the order of their least corners, so that searches in buckets stay near in memory.
  Buckets<SortedFacet> facets(result.Surface.Points.size(),
    [&](const auto& visit)
    {
      for (std::size_t i = 0; i < triangles.size(); ++i)
      {
        const FaceKey key(triangles[i]);
        visit(key.Least, SortedFacet{ key.Others, static_cast<int>(i) });
      }
    });
  for (int point = 0; point < facets.GetNumberOfBuckets(); ++point)
  {
    std::sort(facets[point].begin(), facets[point].end());
  }
  std::vector<char> found(triangles.size(), 0);
  std::size_t twice = 0; // TetGen makes such faces of points that are very close to each other
  std::vector<std::array<int, 4>> constraints(result.Cells.size(), { -1, -1, -1, -1 });
  for (int cell = 0; cell < static_cast<int>(result.Cells.size()); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int neighbor = result.Neighbors[cell][f];
      if (neighbor >= 0 && neighbor < cell)
      {
        continue; // the neighbor has searched for their common face
      }
      const FaceKey face(result.OutwardFace(cell, f));
      const auto bucket = facets[face.Least];
      const auto facet =
        std::lower_bound(bucket.begin(), bucket.end(), SortedFacet{ face.Others, -1 });
      if (facet != bucket.end() && facet->Others == face.Others)
      {
        twice += found[facet->Index];
        found[facet->Index] = 1;
        constraints[cell][f] = facet->Index;
        if (neighbor >= 0)
        {
          constraints[neighbor][FaceTowards(result, neighbor, cell)] = facet->Index;
        }
      }
    }
  }
  result.Constraints = FaceConstraints<3>(constraints);
  return std::count(found.begin(), found.end(), 0) + twice;
}

} // namespace carving::helper
