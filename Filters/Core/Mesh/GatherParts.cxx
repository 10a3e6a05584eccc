// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/GatherParts.h"

#include <numeric>
#include <unordered_set>

namespace carving
{
namespace
{

/** Appends the parts and those of their points that have been added to M's own. */
void AppendParts(const ResolvedMesh& parts, ResolvedMesh& mesh)
{
  std::vector<int> indices(parts.Points.size(), -1);
  std::iota(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(mesh.Points.size()), 0);
  for (std::size_t i = 0; i < parts.Facets.size(); ++i)
  {
    Triangle corners = parts.Facets[i];
    for (int& corner : corners)
    {
      int& index = indices[corner];
      if (index < 0)
      {
        index = static_cast<int>(mesh.Points.size());
        mesh.Points.push_back(parts.Points[corner]);
        mesh.PointSources.push_back(parts.PointSources[corner]);
      }
      corner = index;
    }
    AppendFacet<3>(parts, i, corners, mesh);
  }
}

} // namespace

ResolvedMesh GatherParts(const Tetrahedralization& result, const ResolvedMesh& parts)
{
  const ResolvedMesh& whole = result.Unresolved;
  if (whole.Facets.empty())
  {
    return {};
  }
  ResolvedMesh mesh;
  mesh.Points = whole.Points;
  mesh.PointSources = whole.PointSources;
  AppendParts(parts, mesh);
  const std::unordered_set<int> divided(parts.FacetSources.begin(), parts.FacetSources.end());
  for (std::size_t i = 0; i < whole.Facets.size(); ++i)
  {
    // Roundings may leave no part of a triangle.
    if (result.MetShares[i] < 1.0 || divided.count(whole.FacetSources[i]) == 0)
    {
      AppendFacet<3>(whole, i, whole.Facets[i], mesh);
    }
  }
  return mesh;
}

} // namespace carving
