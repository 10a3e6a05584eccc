// SPDX-License-Identifier: BSD-3-Clause
#include "Classification.h"

#include "Vector.h"
#include "Winding.h"

#include <cmath>

namespace carving
{
namespace
{

/** Whether two triangles with the same corners run through them in the same direction. */
bool SameDirection(const Triangle& a, const Triangle& b)
{
  const int i = b[0] == a[0] ? 0 : b[1] == a[0] ? 1 : 2;
  return b[(i + 1) % 3] == a[1];
}

double SixCellVolume(const Tetrahedralization& mesh, int cell)
{
  const std::array<int, 4>& c = mesh.Cells[cell];
  const std::vector<Point>& p = mesh.Surface.Points;
  return SixVolume(p[c[0]], p[c[1]], p[c[2]], p[c[3]]);
}

Point Centroid(const Tetrahedralization& mesh, int cell)
{
  Point sum = { 0.0, 0.0, 0.0 };
  for (const int corner : mesh.Cells[cell])
  {
    for (int i = 0; i < 3; ++i)
    {
      sum[i] += 0.25 * mesh.Surface.Points[corner][i];
    }
  }
  return sum;
}

/** Fills the regions and marks as Void, for now, all that are enclosed; returns their largest cells. */
std::vector<int> FindRegions(const Tetrahedralization& mesh, Classification& result)
{
  const int numberOfCells = static_cast<int>(mesh.Cells.size());
  result.RegionOfCell.assign(numberOfCells, -1);
  std::vector<int> largestCells;
  std::vector<int> stack;
  for (int seed = 0; seed < numberOfCells; ++seed)
  {
    if (result.RegionOfCell[seed] >= 0)
    {
      continue;
    }
    const int region = static_cast<int>(result.Regions.size());
    bool enclosed = true;
    int largest = seed;
    double largestVolume = -1.0;
    result.RegionOfCell[seed] = region;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const int cell = stack.back();
      stack.pop_back();
      const double volume = SixCellVolume(mesh, cell);
      if (volume > largestVolume || (volume == largestVolume && cell < largest))
      {
        largest = cell;
        largestVolume = volume;
      }
      for (int f = 0; f < 4; ++f)
      {
        if (mesh.Constraints[cell][f] >= 0)
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
    Region found;
    found.Kind = enclosed ? RegionKind::Void : RegionKind::Outside;
    result.Regions.push_back(found);
    largestCells.push_back(largest);
  }
  return largestCells;
}

/** Winding numbers of a closed M: a walk from the outside adds up the triangles that it crosses. */
void CountCrossings(const Tetrahedralization& mesh, Classification& result)
{
  struct Crossing
  {
    int Region;
    int Change;
  };
  const int outside = static_cast<int>(result.Regions.size());
  std::vector<std::vector<Crossing>> crossings(outside + 1);
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int triangle = mesh.Constraints[cell][f];
      if (triangle < 0)
      {
        continue;
      }
      const int neighbor = mesh.Neighbors[cell][f];
      const int to = result.RegionOfCell[cell];
      const int from = neighbor < 0 ? outside : result.RegionOfCell[neighbor];
      const bool behind = SameDirection(
        mesh.OutwardFace(static_cast<int>(cell), f), mesh.Surface.Triangles[triangle]);
      const int winding = mesh.Surface.Windings[triangle];
      crossings[from].push_back({ to, behind ? winding : -winding });
    }
  }
  std::vector<char> known(outside + 1, 0);
  std::vector<int> stack = { outside };
  known[outside] = 1;
  for (int region = 0; region < outside; ++region)
  {
    if (result.Regions[region].Kind == RegionKind::Outside)
    {
      known[region] = 1;
      stack.push_back(region);
    }
  }
  while (!stack.empty())
  {
    const int from = stack.back();
    stack.pop_back();
    const double winding = from == outside ? 0.0 : result.Regions[from].Winding;
    for (const Crossing& crossing : crossings[from])
    {
      if (!known[crossing.Region])
      {
        known[crossing.Region] = 1;
        result.Regions[crossing.Region].Winding = winding + crossing.Change;
        stack.push_back(crossing.Region);
      }
    }
  }
}

} // namespace

Classification Classify(const Tetrahedralization& mesh)
{
  Classification result;
  const std::vector<int> largestCells = FindRegions(mesh, result);
  const bool closed = IsClosed(mesh.Surface);
  if (closed)
  {
    CountCrossings(mesh, result);
  }
  for (std::size_t r = 0; r < result.Regions.size(); ++r)
  {
    Region& region = result.Regions[r];
    if (region.Kind == RegionKind::Outside)
    {
      continue;
    }
    if (!closed)
    {
      region.Winding = WindingNumber(mesh.Surface, Centroid(mesh, largestCells[r]));
      region.Guessed = std::abs(region.Winding - std::round(region.Winding)) > 0.1;
    }
    if (std::abs(region.Winding) >= 0.5)
    {
      region.Kind = RegionKind::Solid;
    }
  }
  return result;
}

} // namespace carving
