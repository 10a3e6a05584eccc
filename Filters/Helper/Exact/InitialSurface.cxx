// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Exact/InitialSurface.h"

#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/Intersections.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

using namespace carving;

namespace
{

constexpr const char* Prefix = "The initial approximation on port 1 ";

/** Added to `Multiplicities` of what lies on C0: more than the equal triangles that any input has. */
constexpr int OnInitial = 1 << 30;

int CountComponents(const ResolvedMesh& mesh)
{
  std::vector<int> parent(mesh.Points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int v)
  {
    while (parent[v] != v)
    {
      v = parent[v] = parent[parent[v]];
    }
    return v;
  };
  int components = static_cast<int>(mesh.Points.size()); // all are used: the mesh is clean
  for (const Triangle& t : mesh.Facets)
  {
    for (const int corner : { t[1], t[2] })
    {
      const int a = find(t[0]), b = find(corner);
      components -= a != b;
      parent[b] = a;
    }
  }
  return components;
}

/** The tetrahedra that are joined to the outside by faces that are not C0's. */
std::vector<char> FindOutside(const Tetrahedralization& mesh)
{
  const auto onInitial = [&](int cell, int f)
  {
    const int facet = mesh.Constraints[cell][f];
    return facet >= 0 && mesh.Surface.Multiplicities[facet] >= OnInitial;
  };
  std::vector<char> outside(mesh.Cells.size(), 0);
  std::vector<int> stack;
  const auto reach = [&](int cell)
  {
    if (!outside[cell])
    {
      outside[cell] = 1;
      stack.push_back(cell);
    }
  };
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      if (mesh.Neighbors[cell][f] < 0 && !onInitial(cell, f))
      {
        reach(cell);
      }
    }
  }
  while (!stack.empty())
  {
    const int cell = stack.back();
    stack.pop_back();
    for (int f = 0; f < 4; ++f)
    {
      if (mesh.Neighbors[cell][f] >= 0 && !onInitial(cell, f))
      {
        reach(mesh.Neighbors[cell][f]);
      }
    }
  }
  return outside;
}

/** Keeps the entries whose `newIndex` is not negative. */
template <class T>
void Compact(std::vector<T>& values, const std::vector<int>& newIndex)
{
  std::size_t to = 0;
  for (std::size_t from = 0; from < values.size(); ++from)
  {
    if (newIndex[from] >= 0)
    {
      values[to++] = values[from];
    }
  }
  values.resize(to);
}

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

void Renumber(std::vector<std::array<int, 4>>& tuples, const std::vector<int>& newIndex)
{
  for (std::array<int, 4>& tuple : tuples)
  {
    for (int& index : tuple)
    {
      index = index < 0 ? index : newIndex[index];
    }
  }
}

} // namespace

std::string CheckInitialSurface(const TriangleMesh& initial)
{
  const ResolvedMesh mesh = Clean(AsResolved(initial));
  if (mesh.Facets.empty())
  {
    return std::string(Prefix) + "has no triangle with an area.";
  }
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : mesh.Facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      ++uses[std::minmax(t[i], t[(i + 1) % 3])];
    }
  }
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
    add("is not closed (", open, " edges have not two triangles)");
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
  return problems.tellp() > 0 ? Prefix + problems.str() + "." : std::string();
}

void AddInitialSurface(const TriangleMesh& initial, ResolvedMesh& surface)
{
  const int firstPoint = static_cast<int>(surface.Points.size());
  surface.Points.insert(surface.Points.end(), initial.Points.begin(), initial.Points.end());
  surface.PointSources.resize(surface.Points.size(), -1);
  for (const Triangle& t : initial.Triangles)
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
  const std::vector<char> outside = FindOutside(mesh);
  std::vector<char> enclosed(surface.Facets.size(), 0);
  std::vector<char> keep(mesh.Cells.size());
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    keep[cell] = !outside[cell];
    for (const int facet : mesh.Constraints[cell])
    {
      if (keep[cell] && facet >= 0)
      {
        enclosed[facet] = 1;
      }
    }
  }
  std::set<int> strays;
  std::vector<char> ofInput(surface.Facets.size(), 0);
  for (std::size_t facet = 0; facet < surface.Facets.size(); ++facet)
  {
    ofInput[facet] = surface.Multiplicities[facet] % OnInitial > 0;
    surface.Multiplicities[facet] %= OnInitial;
    if (ofInput[facet] && !enclosed[facet])
    {
      strays.insert(surface.FacetSources[facet]);
    }
  }
  if (!strays.empty())
  {
    return Prefix + std::string("does not contain the input: ") + std::to_string(strays.size()) +
      " of the input's triangles lie outside of it, at least in part, the first of them triangle " +
      std::to_string(*strays.begin()) + ".";
  }
  const std::vector<int> newCells = Number(keep);
  Compact(mesh.Cells, newCells);
  Compact(mesh.Neighbors, newCells);
  Compact(mesh.Constraints, newCells);
  Renumber(mesh.Neighbors, newCells);
  const std::vector<int> newFacets = Number(ofInput);
  Compact(surface.Facets, newFacets);
  Compact(surface.FacetSources, newFacets);
  Compact(surface.SignedMultiplicities, newFacets);
  Compact(surface.Multiplicities, newFacets);
  Renumber(mesh.Constraints, newFacets);
  return {};
}
