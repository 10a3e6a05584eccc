// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Classification.h"

#include "Core/Mesh/Fetch.h"
#include "Core/Mesh/ForEach.h"
#include "Core/Solid/RayCrossings.h"
#include "Core/Solid/RegionGraph.h"
#include "Core/Solid/RegionWindings.h"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace carving
{
namespace
{

/** Regions separated from the outside by an odd number of triangles are solid. */
template <int D>
void ClassifyByParity(const Decomposition<D>& mesh, Classification& result)
{
  // Dijkstra's shortest paths by the number of triangles crossed. No path leads through facets that
  // stand for no triangle, with which SealCracks divides regions.
  using Entry = std::pair<int, int>; // crossed so far, region
  const auto crossings = FindCrossings(mesh, result);
  constexpr int unknown = std::numeric_limits<int>::max();
  std::vector<int> crossed(crossings.size(), unknown);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const int region : FindOutside(result))
  {
    crossed[region] = 0;
    queue.push({ 0, region });
  }
  while (!queue.empty())
  {
    const auto [distance, from] = queue.top();
    queue.pop();
    if (distance > crossed[from])
    {
      continue;
    }
    for (const Crossing& crossing : crossings[from])
    {
      const int count = mesh.Surface.Multiplicities[crossing.Triangle];
      const int through = distance + count;
      if (count > 0 && through < crossed[crossing.Region])
      {
        crossed[crossing.Region] = through;
        queue.push({ through, crossing.Region });
      }
    }
  }
  for (std::size_t from = 0; from < crossings.size(); ++from)
  {
    if (crossed[from] == unknown)
    {
      continue;
    }
    for (const Crossing& crossing : crossings[from])
    {
      Region& region = result.Regions[crossing.Region];
      const int count = mesh.Surface.Multiplicities[crossing.Triangle];
      const bool odd = crossed[crossing.Region] % 2 != 0;
      if (region.Kind != RegionKind::Outside && count > 0)
      {
        region.Kind = odd ? RegionKind::Solid : RegionKind::Void;
        // Guessed if another path has another parity.
        region.Guessed = region.Guessed || ((crossed[from] + count) % 2 != 0) != odd;
      }
    }
  }
}

/** Parity by rays, for enclosing mode, where kept tetrahedra block the paths. */
void ClassifyByRays(const Tetrahedralization& mesh, int threads, Classification& result)
{
  const std::vector<int> largestCells = FindLargestCells(mesh, result);
  const RayCrossings crossings(mesh.Unresolved);
  ForEach(threads, static_cast<int>(result.Regions.size()),
    [&](int r)
    {
      Region& region = result.Regions[r];
      if (region.Kind == RegionKind::Void)
      {
        const auto [count, other] = crossings.Count(mesh.Centroid(largestCells[r]));
        region.Kind = count % 2 != 0 ? RegionKind::Solid : RegionKind::Void;
        region.Guessed = (count - other) % 2 != 0;
      }
    });
}

template <int D>
void ClassifyByWinding(const Decomposition<D>& mesh, int threads, Classification& result)
{
  FindWindings(mesh, threads, result);
  for (Region& region : result.Regions)
  {
    if (region.Kind == RegionKind::Void && std::abs(region.Winding) >= SolidFrom)
    {
      region.Kind = RegionKind::Solid;
    }
  }
}

} // namespace

template <int D>
Classification FindRegions(const Decomposition<D>& mesh)
{
  Classification result;
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  result.RegionOfCell.assign(numberOfCells, -1);
  if (!mesh.Kept.empty())
  {
    result.Regions.emplace_back().Kind = RegionKind::Kept;
    for (int cell = 0; cell < numberOfCells; ++cell)
    {
      result.RegionOfCell[cell] = mesh.Kept[cell] ? 0 : -1;
    }
  }
  std::vector<int> stack;
  for (int seed = 0; seed < numberOfCells; ++seed)
  {
    if (result.RegionOfCell[seed] >= 0)
    {
      continue;
    }
    const int region = static_cast<int>(result.Regions.size());
    bool enclosed = true;
    result.RegionOfCell[seed] = region;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const int cell = stack.back();
      stack.pop_back();
      FetchNeighbors(mesh, cell, result.RegionOfCell, mesh.Neighbors);
      for (int f = 0; f <= D; ++f)
      {
        if (mesh.Constraints.Has(cell, f))
        {
          continue;
        }
        const int neighbor = mesh.Neighbors[cell][f];
        if (neighbor < 0)
        {
          enclosed = false;
        }
        else if (result.RegionOfCell[neighbor] < 0)
        {
          result.RegionOfCell[neighbor] = region;
          stack.push_back(neighbor);
        }
      }
    }
    result.Regions.emplace_back().Kind = enclosed ? RegionKind::Void : RegionKind::Outside;
  }
  return result;
}

template <int D>
void ClassifyRegions(
  const Decomposition<D>& mesh, SolidRule rule, int threads, Classification& result)
{
  switch (rule)
  {
    case SolidRule::NonzeroWinding:
      ClassifyByWinding(mesh, threads, result);
      break;
    case SolidRule::EvenOdd:
      if constexpr (D == 3)
      {
        if (!mesh.Kept.empty())
        {
          ClassifyByRays(mesh, threads, result);
          break;
        }
      }
      ClassifyByParity(mesh, result);
      break;
    case SolidRule::SurfaceOnly:
      break; // nothing is solid
  }
}

template <int D>
Classification Classify(const Decomposition<D>& mesh, SolidRule rule, int threads)
{
  Classification result = FindRegions(mesh);
  ClassifyRegions(mesh, rule, threads, result);
  return result;
}

template Classification FindRegions<3>(const Decomposition<3>&);
template void ClassifyRegions<3>(const Decomposition<3>&, SolidRule, int, Classification&);

template Classification Classify<2>(const Decomposition<2>&, SolidRule, int);
template Classification Classify<3>(const Decomposition<3>&, SolidRule, int);

} // namespace carving
