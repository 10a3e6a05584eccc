// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Plane/InitialContour.h"

#include "Core/Mesh/Adjacency.h"
#include "Core/Mesh/DisjointSets.h"

#include <algorithm>
#include <cstdio>

using namespace carving;

namespace
{

const std::string Prefix = "The initial approximation on port 1 ";

std::string NamePoint(const Point& p)
{
  char text[100];
  std::snprintf(text, sizeof(text), "(%.6g, %.6g)", p[0], p[1]);
  return text;
}

/** The number of connected pieces that edges make. */
int CountPieces(const Contours& contours)
{
  DisjointSets pieces(contours.Points.size());
  int count = static_cast<int>(contours.Points.size());
  for (const auto& [from, to] : contours.Facets)
  {
    count -= pieces.Find(from) != pieces.Find(to);
    pieces.Unite(from, to);
  }
  return count;
}

/** The first of the checks of one simple polygon that fails. */
std::string CheckSimple(const Contours& given)
{
  Contours contours = Clean(given);
  if (contours.Facets.empty())
  {
    return Prefix + "has no edge of any length.";
  }
  int meetings = 0;
  const std::string error = Resolve(contours, meetings, {});
  if (!error.empty())
  {
    return Prefix + "is too intricate for double precision.";
  }
  std::vector<int> degrees(contours.Points.size(), 0);
  for (const auto& [from, to] : contours.Facets)
  {
    ++degrees[from];
    ++degrees[to];
  }
  for (std::size_t i = 0; i < degrees.size(); ++i)
  {
    if (degrees[i] == 1)
    {
      return Prefix + "is not closed: it ends at " + NamePoint(contours.Points[i]) + ".";
    }
  }
  const auto branch =
    std::find_if(degrees.begin(), degrees.end(), [](int degree) { return degree > 2; });
  if (branch != degrees.end())
  {
    return Prefix + "crosses or touches itself at " +
      NamePoint(contours.Points[branch - degrees.begin()]) + ".";
  }
  if (meetings > 0)
  {
    return Prefix + "runs over itself.";
  }
  const int pieces = CountPieces(contours);
  return pieces == 1 ? std::string()
                     : Prefix + "is in " + std::to_string(pieces) + " pieces; it must be one.";
}

/** Removes the cells that a path joins to the outside without crossing the boundary of C0. */
void RemoveOutside(const std::vector<char>& initial, Decomposition<2>& mesh)
{
  std::vector<char> outside(mesh.Cells.size(), 0);
  std::vector<int> stack;
  const auto visit = [&](int from, int f, int cell)
  {
    const int facet = mesh.Constraints[from][f];
    if (!outside[cell] && (facet < 0 || !initial[facet]))
    {
      outside[cell] = 1;
      stack.push_back(cell);
    }
  };
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f < 3; ++f)
    {
      if (mesh.Neighbors[cell][f] == Outside)
      {
        visit(cell, f, cell);
      }
    }
  }
  while (!stack.empty())
  {
    const int cell = stack.back();
    stack.pop_back();
    for (int f = 0; f < 3; ++f)
    {
      if (mesh.Neighbors[cell][f] >= 0)
      {
        visit(cell, f, mesh.Neighbors[cell][f]);
      }
    }
  }
  std::vector<std::array<int, 3>> kept;
  for (std::size_t cell = 0; cell < outside.size(); ++cell)
  {
    if (!outside[cell])
    {
      kept.push_back(mesh.Cells[cell]);
    }
  }
  mesh.Cells = std::move(kept);
  FindAdjacency(mesh);
}

/** Drops the edges that are of C0 only and finds the first edge of M that is not within C0. */
std::string KeepInput(const ContourSet& given, Decomposition<2>& mesh)
{
  ResolvedInput<2>& surface = mesh.Surface;
  const std::size_t count =
    std::find(surface.Multiplicities.begin(), surface.Multiplicities.end(), 0) -
    surface.Multiplicities.begin();
  surface.Facets.resize(count);
  surface.FacetSources.resize(count);
  surface.SignedMultiplicities.resize(count);
  surface.Multiplicities.resize(count);
  FindAdjacency(mesh);
  std::vector<char> within(count, 0);
  for (const auto& facets : mesh.Constraints)
  {
    for (const int facet : facets)
    {
      if (facet >= 0)
      {
        within[facet] = 1;
      }
    }
  }
  const auto out = std::find(within.begin(), within.end(), 0);
  if (out == within.end())
  {
    return {};
  }
  const auto& [from, to] = given.Edges[surface.FacetSources[out - within.begin()]];
  return Prefix + "does not contain the input: the edge from point " + std::to_string(from) +
    " to point " + std::to_string(to) + " is not within it.";
}

} // namespace

std::string InsertInitialContour(const ContourSet& initial, Contours& contours)
{
  const Contours boundary = AsContours(initial, true);
  const std::string error = CheckSimple(boundary);
  if (!error.empty())
  {
    return error;
  }
  Append(boundary, contours);
  contours = Clean(contours);
  int meetings = 0; // where the input touches C0, which it may
  return Resolve(contours, meetings, {});
}

std::string RemoveOutsideOfInitial(
  const ContourSet& given, const std::vector<char>& initial, Decomposition<2>& mesh)
{
  RemoveOutside(initial, mesh);
  return KeepInput(given, mesh);
}
