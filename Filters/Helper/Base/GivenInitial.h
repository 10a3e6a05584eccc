// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * What a given C0 (section 3.1) needs in space and in the plane alike.
 */
#ifndef carving_GivenInitial_h
#define carving_GivenInitial_h

#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/Mesh.h"

namespace carving::helper
{

/** The beginning of every message about a given C0. */
constexpr const char* InitialPrefix = "The initial approximation on port 1 ";

/** The number of connected components of a mesh that has no unused point. */
template <int D>
int CountComponents(const ResolvedInput<D>& input)
{
  DisjointSets sets(input.Points.size());
  int components = static_cast<int>(input.Points.size());
  for (const auto& facet : input.Facets)
  {
    for (const int corner : facet)
    {
      components -= sets.Find(facet[0]) != sets.Find(corner);
      sets.Unite(facet[0], corner);
    }
  }
  return components;
}

/**
 * Marks the cells within C0: those from which every path to the outside crosses C0. `isInitial`
 * returns whether a facet lies on C0.
 */
template <int D, class IsInitial>
std::vector<char> FindCellsWithin(const Decomposition<D>& mesh, const IsInitial& isInitial)
{
  std::vector<char> within(mesh.Cells.size(), 1);
  std::vector<int> stack;
  const auto cross = [&](int from, int f, int to)
  {
    const int facet = mesh.Constraints.Get(from, f);
    if (within[to] && (facet < 0 || !isInitial(facet)))
    {
      within[to] = 0;
      stack.push_back(to);
    }
  };
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f <= D; ++f)
    {
      if (mesh.Neighbors[cell][f] == Outside)
      {
        cross(cell, f, cell);
      }
    }
  }
  while (!stack.empty())
  {
    const int cell = stack.back();
    stack.pop_back();
    for (int f = 0; f <= D; ++f)
    {
      if (mesh.Neighbors[cell][f] >= 0)
      {
        cross(cell, f, mesh.Neighbors[cell][f]);
      }
    }
  }
  return within;
}

} // namespace carving::helper

#endif
