// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/FacetNeighbors.h"

#include "Core/Mesh/Buckets.h"

#include <algorithm>
#include <utility>

namespace carving::helper
{
namespace
{

/** An edge as a facet has it. */
struct EdgeUse
{
  int Upper; ///< the greater end
  int Facet;
  int Place; ///< of the corner from which the edge leads to the next
  bool Ascending;
};

/** The edges of all facets by their lesser ends. */
Buckets<EdgeUse> CollectEdges(const ResolvedMesh& mesh)
{
  return Buckets<EdgeUse>(mesh.Points.size(),
    [&mesh](auto&& visit)
    {
      for (int f = 0; f < static_cast<int>(mesh.Facets.size()); ++f)
      {
        for (int i = 0; i < 3; ++i)
        {
          const int a = mesh.Facets[f][i], b = mesh.Facets[f][(i + 1) % 3];
          visit(std::min(a, b), EdgeUse{ std::max(a, b), f, i, a < b });
        }
      }
    });
}

} // namespace

std::vector<FacetNeighbors> FindFacetNeighbors(const ResolvedMesh& mesh)
{
  std::vector<FacetNeighbors> neighbors(mesh.Facets.size());
  Buckets<EdgeUse> edges = CollectEdges(mesh);
  for (int lower = 0; lower < edges.GetNumberOfBuckets(); ++lower)
  {
    const auto bucket = edges[lower];
    std::sort(bucket.begin(), bucket.end(),
      [](const EdgeUse& a, const EdgeUse& b)
      { return std::pair(a.Upper, a.Facet) < std::pair(b.Upper, b.Facet); });
    for (auto first = bucket.begin(), end = first; first != bucket.end(); first = end)
    {
      end = std::find_if(first, bucket.end(),
        [upper = first->Upper](const EdgeUse& use) { return use.Upper != upper; });
      if (end - first == 2)
      {
        const EdgeUse &a = first[0], &b = first[1];
        const bool flipped = a.Ascending == b.Ascending;
        neighbors[a.Facet][a.Place] = { b.Facet, flipped };
        neighbors[b.Facet][b.Place] = { a.Facet, flipped };
      }
    }
  }
  return neighbors;
}

} // namespace carving::helper
