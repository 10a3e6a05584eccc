// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Classification.h"

#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/Fetch.h"
#include "Core/Mesh/ForEach.h"
#include "Core/Solid/Winding.h"
#include "Core/Solid/WindingTree.h"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace carving
{
namespace
{

/** Finds the regions. All enclosed ones are marked as Void for now. */
template <int D>
void FindRegions(const Decomposition<D>& mesh, Classification& result)
{
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
}

/** The largest cell of each enclosed region. */
template <int D>
std::vector<int> FindLargestCells(const Decomposition<D>& mesh, const Classification& result)
{
  std::vector<int> largestCells(result.Regions.size(), -1);
  std::vector<double> largestSizes(result.Regions.size(), -1.0);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    if (result.Kind(cell) == RegionKind::Void)
    {
      const int region = result.RegionOfCell[cell];
      const double size = Size(CornersOfCell(mesh, cell));
      if (size > largestSizes[region])
      {
        largestSizes[region] = size;
        largestCells[region] = cell;
      }
    }
  }
  return largestCells;
}

/** A way from one region into another, through a triangle of M. */
struct Crossing
{
  int Region;
  int Winding; ///< change of the winding number
  int Count;   ///< multiplicity of the triangle
};

/** The crossings out of each region. The last entry is that of the outside. */
template <int D>
std::vector<std::vector<Crossing>> FindCrossings(
  const Decomposition<D>& mesh, const Classification& result)
{
  const int outside = static_cast<int>(result.Regions.size());
  std::vector<std::vector<Crossing>> crossings(outside + 1);
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      const int triangle = mesh.Constraints.Get(cell, f);
      if (triangle < 0)
      {
        continue;
      }
      const int neighbor = mesh.Neighbors[cell][f];
      const int to = result.RegionOfCell[cell];
      const int from = neighbor < 0 ? outside : result.RegionOfCell[neighbor];
      const bool behind = SideOfFacet(mesh, cell, f) == 0;
      const int winding = mesh.Surface.SignedMultiplicities[triangle];
      crossings[from].push_back(
        { to, behind ? winding : -winding, mesh.Surface.Multiplicities[triangle] });
    }
  }
  return crossings;
}

/** The outside and all regions connected to it. */
std::vector<int> FindOutside(const Classification& result)
{
  std::vector<int> outside = { static_cast<int>(result.Regions.size()) };
  for (std::size_t region = 0; region < result.Regions.size(); ++region)
  {
    if (result.Regions[region].Kind == RegionKind::Outside)
    {
      outside.push_back(static_cast<int>(region));
    }
  }
  return outside;
}

/**
 * Winding numbers of a closed M: a walk from the outside adds up the changes at the triangles it
 * crosses.
 */
template <int D>
void CountWindings(const Decomposition<D>& mesh, Classification& result)
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
        windings[crossing.Region] = windings[from] + crossing.Winding;
        stack.push_back(crossing.Region);
      }
    }
  }
  for (std::size_t region = 0; region < result.Regions.size(); ++region)
  {
    result.Regions[region].Winding = windings[region];
  }
}

// A winding number this far from the nearest integer is a guess; a magnitude of one half makes a
// region solid.
constexpr double GuessedFrom = 0.1;
constexpr double SolidFrom = 0.5;

/** Winding numbers of any M: sums of solid angles at the centroid of each region's largest cell. */
template <int D>
void MeasureWindings(const Decomposition<D>& mesh, int threads, Classification& result)
{
  const std::vector<int> largestCells = FindLargestCells(mesh, result);
  std::function<double(const Point&)> windingNumber;
  if constexpr (D == 3)
  {
    windingNumber = [tree = WindingTree(mesh.GetInput())](const Point& p) {
      return tree.Measure(p, { GuessedFrom, SolidFrom });
    };
  }
  else
  {
    windingNumber = [&mesh](const Point& p) { return WindingNumber(mesh.Surface, p); };
  }
  ForEach(threads, static_cast<int>(result.Regions.size()),
    [&](int r)
    {
      Region& region = result.Regions[r];
      if (region.Kind == RegionKind::Void)
      {
        region.Winding = windingNumber(mesh.Centroid(largestCells[r]));
        region.Guessed = std::abs(region.Winding - std::round(region.Winding)) > GuessedFrom;
      }
    });
}

/** Regions separated from the outside by an odd number of triangles are solid. */
template <int D>
void ClassifyByParity(const Decomposition<D>& mesh, Classification& result)
{
  // Dijkstra's shortest paths by the number of triangles crossed.
  using Entry = std::pair<int, int>; // crossed so far, region
  const auto crossings = FindCrossings(mesh, result);
  std::vector<int> crossed(crossings.size(), std::numeric_limits<int>::max());
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
      const int through = distance + crossing.Count;
      if (through < crossed[crossing.Region])
      {
        crossed[crossing.Region] = through;
        queue.push({ through, crossing.Region });
      }
    }
  }
  for (std::size_t from = 0; from < crossings.size(); ++from)
  {
    for (const Crossing& crossing : crossings[from])
    {
      Region& region = result.Regions[crossing.Region];
      const bool odd = crossed[crossing.Region] % 2 != 0;
      if (region.Kind != RegionKind::Outside)
      {
        region.Kind = odd ? RegionKind::Solid : RegionKind::Void;
        // Guessed if another path has another parity.
        region.Guessed = region.Guessed || ((crossed[from] + crossing.Count) % 2 != 0) != odd;
      }
    }
  }
}

/** Parity by rays, for enclosing mode, where kept tetrahedra block the paths. */
void ClassifyByRays(const Tetrahedralization& mesh, int threads, Classification& result)
{
  const std::vector<int> largestCells = FindLargestCells(mesh, result);
  ForEach(threads, static_cast<int>(result.Regions.size()),
    [&](int r)
    {
      Region& region = result.Regions[r];
      if (region.Kind == RegionKind::Void &&
        CountCrossings(mesh.Unresolved, mesh.Centroid(largestCells[r])) % 2 != 0)
      {
        region.Kind = RegionKind::Solid;
      }
    });
}

template <int D>
void ClassifyByWinding(const Decomposition<D>& mesh, int threads, Classification& result)
{
  if (mesh.Kept.empty() && IsClosed(mesh.Surface))
  {
    CountWindings(mesh, result);
  }
  else
  {
    MeasureWindings(mesh, threads, result);
  }
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
Classification Classify(const Decomposition<D>& mesh, SolidRule rule, int threads)
{
  Classification result;
  FindRegions(mesh, result);
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
  return result;
}

template Classification Classify<2>(const Decomposition<2>&, SolidRule, int);
template Classification Classify<3>(const Decomposition<3>&, SolidRule, int);

} // namespace carving
