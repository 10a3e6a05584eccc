// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/InitialSurface.h"

#include "Core/Mesh/Box.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Solid/WindingTree.h"
#include "Helper/Base/Cleaning.h"
#include "Helper/Base/GivenInitial.h"
#include "Helper/Resolve/Intersections.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace carving::helper
{
namespace
{

/**
 * Marks triangles on C0: added to `Multiplicities`, and larger than the number of equal triangles
 * in any M.
 */
constexpr int OnInitial = 1 << 30;

std::map<std::pair<int, int>, int> CountUsesOfEdges(const ResolvedMesh& mesh)
{
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : mesh.Facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      ++uses[std::minmax(t[i], t[(i + 1) % 3])];
    }
  }
  return uses;
}

/** The index of each kept entry among the kept entries; -1 for the others. */
std::vector<int> Number(const std::vector<char>& keep)
{
  std::vector<int> newIndex(keep.size(), -1);
  int next = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
  {
    newIndex[i] = keep[i] ? next++ : -1;
  }
  return newIndex;
}

/** Replaces the indices that are not negative. */
void Renumber(std::array<int, 4>& indices, const std::vector<int>& newIndex)
{
  for (int& index : indices)
  {
    index = index < 0 ? index : newIndex[index];
  }
}

/** The error for triangles of the input that lie outside, or an empty string if there are none. */
std::string DescribeOutside(const std::set<int>& outside)
{
  return outside.empty()
    ? std::string()
    : InitialPrefix + std::string("does not contain the input: ") + std::to_string(outside.size()) +
      " of the input's triangles lie outside, at least in part; the first is triangle " +
      std::to_string(*outside.begin()) + ".";
}

/** An error if a facet of M is a face of no tetrahedron within C0, or an empty string. */
std::string CheckContainsInput(const Tetrahedralization& mesh, const std::vector<char>& within)
{
  const ResolvedMesh& surface = mesh.Surface;
  std::vector<char> enclosed(surface.Facets.size(), 0);
  for (int cell = 0; cell < mesh.Constraints.NumberOfCells; ++cell)
  {
    for (const int facet : mesh.Constraints.Get(cell))
    {
      if (within[cell] && facet >= 0)
      {
        enclosed[facet] = 1;
      }
    }
  }
  std::set<int> outside;
  for (std::size_t facet = 0; facet < surface.Facets.size(); ++facet)
  {
    if (surface.Multiplicities[facet] % OnInitial > 0 && !enclosed[facet])
    {
      outside.insert(surface.FacetSources[facet]);
    }
  }
  return DescribeOutside(outside);
}

} // namespace

std::string CheckInitialSurface(const ResolvedMesh& mesh)
{
  if (mesh.Facets.empty())
  {
    return std::string(InitialPrefix) + "has no triangle with an area.";
  }
  const std::map<std::pair<int, int>, int> uses = CountUsesOfEdges(mesh);
  const auto open =
    std::count_if(uses.begin(), uses.end(), [](const auto& edge) { return edge.second != 2; });
  const int components = CountComponents(mesh);
  const int characteristic = static_cast<int>(mesh.Points.size()) - static_cast<int>(uses.size()) +
    static_cast<int>(mesh.Facets.size());
  const std::size_t crossings = FindIntersections(mesh.Points, mesh.Facets).size();

  std::ostringstream problems;
  const auto add = [&](const auto&... parts)
  {
    problems << (problems.tellp() > 0 ? ", " : "");
    (problems << ... << parts);
  };
  if (open > 0)
  {
    add("is not closed (", open, " edges do not have two triangles)");
  }
  if (components != 1)
  {
    add("is not one component but ", components);
  }
  if (open == 0 && components == 1 && characteristic != 2)
  {
    add("is not of genus zero (its Euler characteristic is ", characteristic, ", not 2)");
  }
  if (crossings > 0)
  {
    add("intersects itself (", crossings, " pairs of triangles)");
  }
  return problems.tellp() > 0 ? InitialPrefix + problems.str() + "." : std::string();
}

std::string CheckPointsWithin(const ResolvedMesh& initial, const ResolvedMesh& surface)
{
  constexpr double touching = 1e-9; // of the diagonal
  constexpr double half = 0.5;
  const double least = touching * Diagonal(initial.Points);
  const FacetTree<3> tree(initial);
  const WindingTree windings(initial);
  std::vector<char> isOutside(surface.Points.size(), 0);
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const Point& p = surface.Points[i];
    isOutside[i] =
      std::abs(windings.Measure(p, { half })) < half && tree.Find(p, least).Distance > least;
  }
  std::set<int> outside;
  for (std::size_t facet = 0; facet < surface.Facets.size(); ++facet)
  {
    const Triangle& t = surface.Facets[facet];
    if (std::any_of(t.begin(), t.end(), [&](int corner) { return isOutside[corner]; }))
    {
      outside.insert(surface.FacetSources[facet]);
    }
  }
  return DescribeOutside(outside);
}

void AddInitialSurface(const ResolvedMesh& initial, ResolvedMesh& surface)
{
  const int firstPoint = static_cast<int>(surface.Points.size());
  surface.Points.insert(surface.Points.end(), initial.Points.begin(), initial.Points.end());
  surface.PointSources.resize(surface.Points.size(), -1);
  for (const Triangle& t : initial.Facets)
  {
    surface.Facets.push_back({ t[0] + firstPoint, t[1] + firstPoint, t[2] + firstPoint });
  }
  surface.FacetSources.resize(surface.Facets.size(), -1);
  surface.SignedMultiplicities.resize(surface.Facets.size(), 0);
  surface.Multiplicities.resize(surface.Facets.size(), OnInitial);
}

std::string RemoveOutsideOfInitial(Tetrahedralization& mesh)
{
  ResolvedMesh& surface = mesh.Surface;
  const std::vector<char> within =
    FindCellsWithin(mesh, [&](int facet) { return surface.Multiplicities[facet] >= OnInitial; });
  const std::string error = CheckContainsInput(mesh, within);
  if (!error.empty())
  {
    return error;
  }
  std::vector<char> ofInput;
  for (int& multiplicity : surface.Multiplicities)
  {
    multiplicity %= OnInitial;
    ofInput.push_back(multiplicity > 0);
  }
  CompactFacets(surface, ofInput);
  const std::vector<int> newFacets = Number(ofInput), newCells = Number(within);
  FaceConstraints<3> constraints;
  for (int cell = 0; cell < mesh.Constraints.NumberOfCells; ++cell)
  {
    if (within[cell])
    {
      auto facets = mesh.Constraints.Get(cell);
      Renumber(facets, newFacets);
      constraints.Append(facets);
      Renumber(mesh.Neighbors[cell], newCells);
    }
  }
  mesh.Constraints = std::move(constraints);
  Compact(mesh.Cells, within);
  Compact(mesh.Neighbors, within);
  return {};
}

} // namespace carving::helper
