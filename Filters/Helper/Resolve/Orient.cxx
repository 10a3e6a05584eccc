// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Resolve/Orient.h"

#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/DisjointSets.h"
#include "Core/Mesh/FacetTree.h"
#include "Helper/Resolve/FacetNeighbors.h"

#include <utility>
#include <vector>

namespace carving::helper
{
namespace
{

/** Two facets, each given once, that share an edge which no other facet has. */
struct Pair
{
  int First, Second;
  bool AreAlike; ///< oriented alike
};

/** All pairs, or none if no triangle has to be turned. */
std::vector<Pair> FindPairsUnlessAlike(const ResolvedMesh& mesh)
{
  std::vector<Pair> pairs;
  bool areAllAlike = true;
  const std::vector<FacetNeighbors> neighbors = FindFacetNeighbors(mesh);
  for (int f = 0; f < static_cast<int>(neighbors.size()); ++f)
  {
    for (const auto& [neighbor, flipped] : neighbors[f])
    {
      if (neighbor > f && mesh.Multiplicities[f] == 1 && mesh.Multiplicities[neighbor] == 1)
      {
        const bool haveSameSign =
          mesh.SignedMultiplicities[f] == mesh.SignedMultiplicities[neighbor];
        pairs.push_back({ f, neighbor, haveSameSign != flipped });
        areAllAlike = areAllAlike && pairs.back().AreAlike;
      }
    }
  }
  return areAllAlike ? std::vector<Pair>() : pairs;
}

} // namespace

void OrientAlike(ResolvedMesh& mesh)
{
  const std::vector<Pair> pairs = FindPairsUnlessAlike(mesh);
  if (pairs.empty())
  {
    return;
  }
  // Members 2 f and 2 f + 1 are facet f as given and turned. Members of a set go together.
  const std::size_t count = mesh.Facets.size();
  DisjointSets sets(2 * count);
  std::vector<char> sides(count, 0); // that belong to a pair
  for (const auto& [first, second, areAlike] : pairs)
  {
    sets.Unite(2 * first, 2 * second + (areAlike ? 0 : 1));
    sets.Unite(2 * first + 1, 2 * second + (areAlike ? 1 : 0));
    ++sides[first];
    ++sides[second];
  }
  std::vector<char> isOpen(2 * count, 0);    // per set
  std::vector<double> areas(2 * count, 0.0); // of the facets as given in each set
  for (std::size_t f = 0; f < count; ++f)
  {
    const int given = sets.Find(static_cast<int>(2 * f));
    const int turned = sets.Find(static_cast<int>(2 * f + 1));
    areas[given] += Size(carving::CornersOf<3>(mesh.Points, mesh.Facets[f]));
    isOpen[given] = isOpen[given] || sides[f] < 3;
    isOpen[turned] = isOpen[turned] || sides[f] < 3;
  }
  for (std::size_t f = 0; f < count; ++f)
  {
    const int given = sets.Find(static_cast<int>(2 * f));
    const int turned = sets.Find(static_cast<int>(2 * f + 1)); // the same on a surface of one side
    if (!isOpen[given] && std::pair(-areas[given], given) > std::pair(-areas[turned], turned))
    {
      mesh.SignedMultiplicities[f] = -mesh.SignedMultiplicities[f];
    }
  }
}

} // namespace carving::helper
