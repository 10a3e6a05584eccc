// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/RegionWindings.h"

#include "Core/Mesh/ForEach.h"
#include "Core/Solid/RegionGraph.h"
#include "Core/Solid/Winding.h"
#include "Core/Solid/WindingTree.h"

#include <cmath>
#include <functional>

namespace carving
{
namespace
{

/**
 * Winding numbers of the closed parts of M: a walk from the outside adds up the changes at the
 * triangles it crosses.
 */
template <int D>
void CountWindings(
  const Decomposition<D>& mesh, const std::vector<char>& isClosed, Classification& result)
{
  const auto crossings = FindCrossings(mesh, result);
  std::vector<int> stack = FindOutside(result);
  std::vector<int> windings(crossings.size(), 0);
  std::vector<char> known(crossings.size(), 0);
  for (const int region : stack)
  {
    known[region] = 1;
  }
  while (!stack.empty())
  {
    const int from = stack.back();
    stack.pop_back();
    for (const Crossing& crossing : crossings[from])
    {
      if (!known[crossing.Region])
      {
        known[crossing.Region] = 1;
        const int change =
          isClosed[crossing.Triangle] ? mesh.Surface.SignedMultiplicities[crossing.Triangle] : 0;
        windings[crossing.Region] = windings[from] + (crossing.IntoBehind ? change : -change);
        stack.push_back(crossing.Region);
      }
    }
  }
  for (std::size_t region = 0; region < result.Regions.size(); ++region)
  {
    result.Regions[region].Winding = windings[region];
  }
}

// A winding number this far from the nearest integer is a guess.
constexpr double GuessedFrom = 0.1;

/** The parts of M that are not closed. */
template <int D>
ResolvedInput<D> ExtractOpenParts(
  const ResolvedInput<D>& surface, const std::vector<char>& isClosed)
{
  ResolvedInput<D> open;
  for (std::size_t i = 0; i < surface.Facets.size(); ++i)
  {
    if (!isClosed[i])
    {
      AppendFacet<D>(surface, i, surface.Facets[i], open);
    }
  }
  if (!open.Facets.empty())
  {
    open.Points = surface.Points;
  }
  return open;
}

/**
 * Adds the winding numbers of facets, at the centroid of each region's largest cell: sums of solid
 * angles.
 */
template <int D>
void MeasureWindings(
  const Decomposition<D>& mesh, const ResolvedInput<D>& facets, int threads, Classification& result)
{
  const std::vector<int> largestCells = FindLargestCells(mesh, result);
  std::function<double(const Point&)> windingNumber;
  if constexpr (D == 3)
  {
    windingNumber = [tree = WindingTree(facets)](const Point& p) {
      return tree.Measure(p, { GuessedFrom, SolidFrom });
    };
  }
  else
  {
    windingNumber = [&facets](const Point& p) { return WindingNumber(facets, p); };
  }
  ForEach(threads, static_cast<int>(result.Regions.size()),
    [&](int r)
    {
      Region& region = result.Regions[r];
      if (region.Kind == RegionKind::Void)
      {
        region.Winding += windingNumber(mesh.Centroid(largestCells[r]));
        region.Guessed = std::abs(region.Winding - std::round(region.Winding)) > GuessedFrom;
      }
    });
}

} // namespace

template <int D>
void FindWindings(const Decomposition<D>& mesh, int threads, Classification& result)
{
  if (mesh.Kept.empty())
  {
    const std::vector<char> isClosed = FindClosedParts(mesh.Surface);
    CountWindings(mesh, isClosed, result);
    const ResolvedInput<D> open = ExtractOpenParts(mesh.Surface, isClosed);
    if (!open.Facets.empty())
    {
      MeasureWindings(mesh, open, threads, result);
    }
  }
  else
  {
    MeasureWindings(mesh, mesh.GetInput(), threads, result);
  }
}

template void FindWindings<2>(const Decomposition<2>&, int, Classification&);
template void FindWindings<3>(const Decomposition<3>&, int, Classification&);

} // namespace carving
