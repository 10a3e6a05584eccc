// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Plane/InitialContour.h"

#include "Core/Mesh/Adjacency.h"
#include "Helper/Base/Cleaning.h"
#include "Helper/Base/GivenInitial.h"

#include <algorithm>
#include <cstdio>

namespace carving::helper
{
namespace
{

const std::string Prefix = InitialPrefix;

std::string NamePoint(const Point& p)
{
  char text[100];
  std::snprintf(text, sizeof(text), "(%.6g, %.6g)", p[0], p[1]);
  return text;
}

/** The number of edges at every point. */
std::vector<int> CountEdges(const Contours& contours)
{
  std::vector<int> degrees(contours.Points.size(), 0);
  for (const auto& [from, to] : contours.Facets)
  {
    ++degrees[from];
    ++degrees[to];
  }
  return degrees;
}

/**
 * A message about the first reason why edges are not the boundary of one simple polygon, or an
 * empty string.
 */
std::string CheckSimple(const Contours& given)
{
  Contours contours = Clean(given);
  if (contours.Facets.empty())
  {
    return Prefix + "has no edge of any length.";
  }
  int splitPoints = 0;
  const std::string error = Resolve(contours, splitPoints, {});
  if (!error.empty())
  {
    return Prefix + "is too intricate for double precision.";
  }
  const std::vector<int> degrees = CountEdges(contours);
  const auto end = std::find(degrees.begin(), degrees.end(), 1);
  if (end != degrees.end())
  {
    return Prefix + "is not closed: it ends at " +
      NamePoint(contours.Points[end - degrees.begin()]) + ".";
  }
  const auto branch =
    std::find_if(degrees.begin(), degrees.end(), [](int degree) { return degree > 2; });
  if (branch != degrees.end())
  {
    return Prefix + "crosses or touches itself at " +
      NamePoint(contours.Points[branch - degrees.begin()]) + ".";
  }
  if (splitPoints > 0)
  {
    return Prefix + "overlaps itself.";
  }
  const int components = CountComponents<2>(contours);
  return components == 1
    ? std::string()
    : Prefix + "is in " + std::to_string(components) + " pieces instead of one.";
}

/** A message about the first edge of M that is not within C0, or an empty string. */
std::string CheckContainsInput(const ContourSet& given, const Decomposition<2>& mesh)
{
  std::vector<char> within(mesh.Surface.Facets.size(), 0);
  for (const int facet : mesh.Constraints.OfFaces)
  {
    within[facet] = 1;
  }
  const auto outside = std::find(within.begin(), within.end(), 0);
  if (outside == within.end())
  {
    return {};
  }
  const auto& [from, to] = given.Edges[mesh.Surface.FacetSources[outside - within.begin()]];
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
  int splitPoints = 0; // where M touches C0, which is allowed
  return Resolve(contours, splitPoints, {});
}

std::string RemoveOutsideOfInitial(
  const ContourSet& given, const std::vector<char>& initial, Decomposition<2>& mesh)
{
  Compact(mesh.Cells, FindCellsWithin(mesh, [&](int facet) { return initial[facet] != 0; }));
  ResolvedInput<2>& surface = mesh.Surface;
  std::vector<char> ofInput;
  for (const int multiplicity : surface.Multiplicities)
  {
    ofInput.push_back(multiplicity > 0);
  }
  CompactFacets(surface, ofInput);
  FindAdjacency(mesh);
  return CheckContainsInput(given, mesh);
}

} // namespace carving::helper
