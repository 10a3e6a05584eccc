// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Interior.h"

#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Core/Solid/Winding.h"
#include "Helper/Base/ExactWinding.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/FacetNeighbors.h"

#include <algorithm>
#include <optional>

namespace carving::helper
{
namespace
{

/** The winding numbers on both sides of a facet. */
struct Sides
{
  int Front = 0;
  int Behind = 0;
};

/** Twice the area divided by the longest edge: the least height. */
double Width(const ResolvedMesh& mesh, int facet)
{
  const auto& [a, b, c] = mesh.Facets[facet];
  const Point &p = mesh.Points[a], &q = mesh.Points[b], &r = mesh.Points[c];
  return Length(Cross(q - p, r - p)) / std::max({ Length(q - p), Length(r - q), Length(p - r) });
}

/** The facets that are connected to `seed` by neighbors, `seed` first. */
std::vector<int> Patch(
  int seed, const std::vector<FacetNeighbors>& neighbors, std::vector<char>& reached)
{
  std::vector<int> patch = { seed };
  reached[seed] = 1;
  for (std::size_t i = 0; i < patch.size(); ++i)
  {
    for (const FacetNeighbor& neighbor : neighbors[patch[i]])
    {
      if (neighbor.Facet >= 0 && !reached[neighbor.Facet])
      {
        reached[neighbor.Facet] = 1;
        patch.push_back(neighbor.Facet);
      }
    }
  }
  return patch;
}

/**
 * Finds the winding numbers on both sides of every facet. One measurement per patch suffices, at
 * its widest facet: from a facet to its neighbor, the winding numbers of the two sides do not
 * change. Returns false if one cannot be found.
 */
bool MeasureSides(const ResolvedMesh& mesh, std::vector<Sides>& sides)
{
  const std::vector<FacetNeighbors> neighbors = FindFacetNeighbors(mesh);
  const ExactWinding winding(mesh);
  const int numberOfFacets = static_cast<int>(mesh.Facets.size());
  sides.resize(numberOfFacets);
  std::vector<char> reached(numberOfFacets, 0), known(numberOfFacets, 0);
  for (int seed = 0; seed < numberOfFacets; ++seed)
  {
    if (reached[seed])
    {
      continue;
    }
    const std::vector<int> patch = Patch(seed, neighbors, reached);
    const int widest = *std::max_element(
      patch.begin(), patch.end(), [&](int a, int b) { return Width(mesh, a) < Width(mesh, b); });
    const std::optional<int> front = winding.InFrontOf(widest);
    if (!front)
    {
      return false;
    }
    sides[widest] = { *front, *front + mesh.SignedMultiplicities[widest] };
    for (const int facet : Patch(widest, neighbors, known))
    {
      for (const FacetNeighbor& neighbor : neighbors[facet])
      {
        if (neighbor.Facet >= 0)
        {
          const auto& [ahead, behind] = sides[facet];
          sides[neighbor.Facet] = neighbor.Flipped ? Sides{ behind, ahead } : sides[facet];
        }
      }
    }
  }
  return true;
}

bool IsSolid(SolidRule rule, int winding)
{
  return rule == SolidRule::EvenOdd ? winding % 2 != 0 : winding != 0;
}

} // namespace

int DropInterior(SolidRule rule, ResolvedMesh& mesh)
{
  std::vector<Sides> sides;
  if (rule == SolidRule::SurfaceOnly || !IsClosed(mesh) || !MeasureSides(mesh, sides))
  {
    return 0;
  }
  ResolvedMesh boundary;
  boundary.Points = mesh.Points;
  boundary.PointSources = mesh.PointSources;
  for (std::size_t f = 0; f < mesh.Facets.size(); ++f)
  {
    const bool front = IsSolid(rule, sides[f].Front), behind = IsSolid(rule, sides[f].Behind);
    if (!front || !behind)
    {
      AppendFacet<3>(mesh, f, mesh.Facets[f], boundary);
      boundary.SignedMultiplicities.back() = behind - front;
      boundary.Multiplicities.back() = behind == front ? 2 : 1;
    }
  }
  const std::size_t dropped = mesh.Facets.size() - boundary.Facets.size();
  if (dropped == 0 || !IsClosed(boundary)) // not closed: some facets cross each other after all
  {
    return 0;
  }
  mesh = Clean(boundary);
  return static_cast<int>(dropped);
}

} // namespace carving::helper
