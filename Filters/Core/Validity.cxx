// SPDX-License-Identifier: BSD-3-Clause
#include "Validity.h"

#include <algorithm>

namespace carving
{
namespace
{

/** Both sides of every face must agree on who the neighbors are and on the constraint. */
template <int D>
bool NeighborsAgree(const Decomposition<D>& mesh)
{
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      const int neighbor = mesh.Neighbors[cell][f];
      if (neighbor < 0)
      {
        continue;
      }
      const auto& back = mesh.Neighbors[neighbor];
      const auto found = std::find(back.begin(), back.end(), static_cast<int>(cell));
      if (found == back.end() ||
        mesh.Constraints[neighbor][found - back.begin()] != mesh.Constraints[cell][f])
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

template <int D>
std::string FindMistake(const Decomposition<D>& mesh)
{
  const ResolvedInput<D>& surface = mesh.Surface;
  const std::size_t triangles = surface.Facets.size();
  if (surface.PointSources.size() != surface.Points.size() ||
    surface.FacetSources.size() != triangles || surface.Windings.size() != triangles ||
    surface.Counts.size() != triangles || mesh.Neighbors.size() != mesh.Cells.size() ||
    mesh.Constraints.size() != mesh.Cells.size() ||
    (!mesh.Kept.empty() && mesh.Kept.size() != mesh.Cells.size()))
  {
    return "arrays that belong together differ in length";
  }
  const ResolvedInput<D>& input = mesh.Unresolved;
  if (input.Windings.size() != input.Facets.size() || input.Counts.size() != input.Facets.size())
  {
    return "arrays that belong together differ in length";
  }
  if (!IndicesWithin(surface.Facets, 0, surface.Points.size()) ||
    !IndicesWithin(input.Facets, 0, input.Points.size()) ||
    !IndicesWithin(mesh.Cells, 0, surface.Points.size()))
  {
    return "a vertex index is out of range";
  }
  if (!IndicesWithin(mesh.Neighbors, -1, mesh.Cells.size()) ||
    !IndicesWithin(mesh.Constraints, -1, triangles))
  {
    return "a neighbor or constraint index is out of range";
  }
  if (!NeighborsAgree(mesh))
  {
    return "neighboring tetrahedra disagree about their common face";
  }
  return {};
}

template std::string FindMistake<2>(const Decomposition<2>&);
template std::string FindMistake<3>(const Decomposition<3>&);

} // namespace carving
