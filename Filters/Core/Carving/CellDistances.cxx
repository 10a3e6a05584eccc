// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/CellDistances.h"

#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/ForEach.h"
#include "Core/Mesh/LargePages.h"

#include <algorithm>

namespace carving
{
namespace
{

/** The distance of each cell's centroid from facets; 0 if there are none. */
template <int D>
std::vector<double> MeasureDistancesFrom(
  const ResolvedInput<D>& facets, const Decomposition<D>& mesh, int threads)
{
  std::vector<double> distances = MakeLarge<double>(mesh.Cells.size());
  if (facets.Facets.empty())
  {
    return distances;
  }
  const FacetTree<D> tree(facets);
  constexpr int part = 1024; // cells that a thread takes at a time
  const int count = static_cast<int>(distances.size());
  ForEach(threads, (count + part - 1) / part,
    [&](int i)
    {
      for (int cell = i * part; cell < std::min((i + 1) * part, count); ++cell)
      {
        distances[cell] = tree.Find(mesh.Centroid(cell)).Distance;
      }
    });
  return distances;
}

/**
 * The surface of the initial approximation: the faces of cells without a neighbor. If the cells of
 * the solid are not stored, those of them that lie on the surface are facets of M with the solid on
 * one side and no cell on the other.
 */
template <int D>
ResolvedInput<D> ExtractInitialSurface(const Decomposition<D>& mesh, const Classification& regions)
{
  ResolvedInput<D> surface;
  surface.Points = mesh.Surface.Points;
  std::vector<char> hasCell(regions.SolidRegions.size(), 0);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      const int facet = hasCell.empty() ? -1 : mesh.Constraints.Get(cell, f);
      if (facet >= 0)
      {
        hasCell[facet] = 1;
      }
      if (mesh.Neighbors[cell][f] == Outside)
      {
        surface.Facets.push_back(mesh.OutwardFace(cell, f));
      }
    }
  }
  for (std::size_t facet = 0; facet < hasCell.size(); ++facet)
  {
    const auto [behind, inFront] = regions.SolidRegions[facet];
    if (!hasCell[facet] && (behind < 0) != (inFront < 0))
    {
      surface.Facets.push_back(mesh.Surface.Facets[facet]);
    }
  }
  // Roundings of distances depend on the order, which must not depend on what is stored.
  for (auto& facet : surface.Facets)
  {
    std::sort(facet.begin(), facet.end());
  }
  std::sort(surface.Facets.begin(), surface.Facets.end());
  return surface;
}

} // namespace

template <int D>
std::vector<double> MeasureDistances(const Decomposition<D>& mesh, int threads)
{
  return MeasureDistancesFrom<D>(mesh.GetInput(), mesh, threads);
}

template <int D>
std::vector<double> MeasureDepths(
  const Decomposition<D>& mesh, const Classification& regions, int threads)
{
  const double smallest = 1e-9 * Diagonal(mesh.GetInput());
  std::vector<double> depths =
    MeasureDistancesFrom<D>(ExtractInitialSurface(mesh, regions), mesh, threads);
  for (double& depth : depths)
  {
    depth = std::max(depth, smallest);
  }
  return depths;
}

template std::vector<double> MeasureDistances<2>(const Decomposition<2>&, int);
template std::vector<double> MeasureDistances<3>(const Decomposition<3>&, int);
template std::vector<double> MeasureDepths<2>(const Decomposition<2>&, const Classification&, int);
template std::vector<double> MeasureDepths<3>(const Decomposition<3>&, const Classification&, int);

} // namespace carving
