// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Resolve.h"

#include "Core/Mesh/DisjointSets.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/CoplanarGroup.h"
#include "Helper/Resolve/Imprint.h"
#include "Helper/Resolve/Intersections.h"

#include <algorithm>
#include <functional>

namespace carving::helper
{
namespace
{

using Pairs = std::vector<std::pair<int, int>>;

/** The triangles that intersect others, by plane. */
struct Grouping
{
  std::vector<CoplanarGroup> Groups;
  std::vector<int> GroupOf; ///< one entry per triangle; -1: none
};

/**
 * Puts the triangles of each coplanar pair into one group, and removes these pairs from `pairs`.
 */
Grouping FindGroups(const ResolvedMesh& mesh, Pairs& pairs)
{
  const int count = static_cast<int>(mesh.Facets.size());
  std::vector<char> meets(count, 0);
  DisjointSets sets(count);
  const auto unite = [&](const std::pair<int, int>& pair)
  {
    const auto& [a, b] = pair;
    meets[a] = meets[b] = 1;
    const bool coplanar = AreCoplanar(mesh, a, b);
    if (coplanar)
    {
      sets.Unite(a, b);
    }
    return coplanar;
  };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), unite), pairs.end());
  Grouping result;
  result.GroupOf.assign(count, -1);
  for (int i = 0; i < count; ++i)
  {
    if (meets[i])
    {
      const int first = sets.Find(i);
      if (first == i)
      {
        result.GroupOf[i] = static_cast<int>(result.Groups.size());
        result.Groups.emplace_back();
      }
      result.GroupOf[i] = result.GroupOf[first];
      CoplanarGroup& group = result.Groups[result.GroupOf[i]];
      group.Triangles.push_back(i);
      AppendSides(mesh, i, group.Sides);
    }
  }
  return result;
}

/** Makes one round of splitting. */
ResolvedMesh Split(const ResolvedMesh& mesh, Pairs pairs, const Progress& progress)
{
  Grouping grouping = FindGroups(mesh, pairs);
  CutPoints cutPoints(mesh);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    GoOn(progress, 0.5 * i / pairs.size());
    const auto& [a, b] = pairs[i];
    const std::array<int, 2> common = cutPoints.Intersect(a, b);
    for (const int triangle : { a, b })
    {
      grouping.Groups[grouping.GroupOf[triangle]].Cuts.push_back(common);
    }
  }
  ResolvedMesh result;
  result.Points = mesh.Points;
  result.PointSources = mesh.PointSources;
  cutPoints.AppendRounded(result);
  const int count = static_cast<int>(mesh.Facets.size());
  for (int i = 0; i < count; ++i)
  {
    GoOn(progress, 0.5 + 0.5 * i / count);
    const int group = grouping.GroupOf[i];
    if (group < 0)
    {
      AppendFacet<3>(mesh, i, mesh.Facets[i], result);
    }
    else if (grouping.Groups[group].Triangles.front() == i)
    {
      AppendPieces(mesh, cutPoints, grouping.Groups[group], result);
    }
  }
  return result;
}

constexpr std::size_t MostOnBoxes = 20000; ///< pairs, which are resolved in about two seconds

/** The number of pairs that need not be known: whatever their kind, they are too many. */
std::size_t MoreThan(double maximumPairs)
{
  const double limit = std::max(maximumPairs, static_cast<double>(MostOnBoxes)) + 1.0;
  return limit < static_cast<double>(MostIntersections) ? static_cast<std::size_t>(limit)
                                                        : MostIntersections;
}

/**
 * The number of pairs that counts for a limit. Boxes that touch have walls in common planes, and
 * their other walls cross in common lines, so that few points come of many pairs.
 */
std::size_t CountForLimit(const ResolvedMesh& mesh, const Pairs& pairs)
{
  constexpr std::size_t forEachInPlane = 4; // the pair itself, and others in the same lines
  if (pairs.size() > MostOnBoxes)
  {
    return pairs.size();
  }
  const std::size_t inPlane = std::count_if(pairs.begin(), pairs.end(),
    [&mesh](const auto& pair) { return AreCoplanar(mesh, pair.first, pair.second); });
  return pairs.size() - std::min(pairs.size(), forEachInPlane * inPlane);
}

/** Splits until no pair is left. The search for the pairs ended at `most`. */
std::string SplitAll(ResolvedMesh& mesh, Pairs pairs, std::size_t most,
  const std::function<ResolvedMesh(Pairs)>& split, double maximumPairs)
{
  // One round suffices for nearly every mesh. Where a round makes crossings rather than fewer,
  // hardly any further round mends that, and each takes longer.
  constexpr int maximumRounds = 10;
  const bool areAll = pairs.size() < most;
  if (!areAll ||
    (static_cast<double>(pairs.size()) > maximumPairs &&
      static_cast<double>(CountForLimit(mesh, pairs)) > maximumPairs))
  {
    return (areAll ? "" : "at least ") + std::to_string(pairs.size()) +
      " pairs of triangles cross each other, too many to be resolved.";
  }
  std::size_t before = pairs.size();
  for (int round = 0; !pairs.empty(); ++round)
  {
    if (round == maximumRounds || pairs.size() > before)
    {
      return "After " + std::to_string(round) + " rounds of splitting, " +
        std::to_string(pairs.size()) +
        " pairs of triangles still cross each other: the mesh is too intricate for double "
        "precision.";
    }
    before = pairs.size();
    mesh = split(std::move(pairs));
    pairs = FindIntersections(mesh.Points, mesh.Facets);
  }
  return {};
}

} // namespace

std::string Resolve(
  ResolvedMesh& mesh, int& intersectingPairs, const Progress& progress, double maximumPairs)
{
  const std::size_t most = MoreThan(maximumPairs);
  Pairs pairs = FindIntersections(mesh.Points, mesh.Facets, most);
  intersectingPairs = static_cast<int>(pairs.size());
  return ResolvePairs(mesh, std::move(pairs), progress, maximumPairs, most);
}

std::string ResolvePairs(
  ResolvedMesh& mesh, Pairs pairs, const Progress& progress, double maximumPairs, std::size_t most)
{
  return SplitAll(
    mesh, std::move(pairs), most,
    [&](Pairs crossing) { return Clean(Split(mesh, std::move(crossing), progress)); },
    maximumPairs);
}

std::string ResolveTouching(ResolvedMesh& mesh, double tolerance, double& distance,
  int& intersectingPairs, const Progress& progress, double maximumPairs)
{
  distance = 0.0;
  const std::size_t most = MoreThan(maximumPairs);
  const auto split = [&](const Pairs& pairs)
  {
    GoOn(progress, 0.0);
    return Weld(Imprint(std::move(mesh), pairs, tolerance), tolerance, distance);
  };
  mesh = Weld(std::move(mesh), tolerance, distance);
  Pairs pairs = FindIntersections(mesh.Points, mesh.Facets, most);
  intersectingPairs = static_cast<int>(pairs.size());
  if (pairs.empty()) // triangles may lie on each other without crossing
  {
    mesh = split(pairs);
    pairs = FindIntersections(mesh.Points, mesh.Facets, most);
  }
  return SplitAll(mesh, std::move(pairs), most, split, maximumPairs);
}

} // namespace carving::helper
