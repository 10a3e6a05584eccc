// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Shuffle.h"

#include <numeric>
#include <random>
#include <vector>

namespace carving::helper
{
namespace
{

std::vector<int> Order(std::size_t size, int seed)
{
  std::vector<int> order(size);
  std::iota(order.begin(), order.end(), 0);
  if (seed > 0)
  {
    std::mt19937 random(seed);
    for (std::size_t i = size; i > 1; --i) // std::shuffle differs between standard libraries
    {
      std::swap(order[i - 1], order[random() % i]);
    }
  }
  return order;
}

template <class Value>
std::vector<Value> InOrder(const std::vector<int>& order, const std::vector<Value>& values)
{
  std::vector<Value> result;
  result.reserve(values.size());
  for (const int i : order)
  {
    result.push_back(values[i]);
  }
  return result;
}

} // namespace

void Shuffle(int seed, ResolvedMesh& surface)
{
  const std::vector<int> points = Order(surface.Points.size(), seed),
                         facets = Order(surface.Facets.size(), seed);
  std::vector<int> places(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    places[points[i]] = static_cast<int>(i);
  }
  for (Triangle& t : surface.Facets)
  {
    t = { places[t[0]], places[t[1]], places[t[2]] };
  }
  surface.Points = InOrder(points, surface.Points);
  surface.PointSources = InOrder(points, surface.PointSources);
  surface.Facets = InOrder(facets, surface.Facets);
  surface.FacetSources = InOrder(facets, surface.FacetSources);
  surface.SignedMultiplicities = InOrder(facets, surface.SignedMultiplicities);
  surface.Multiplicities = InOrder(facets, surface.Multiplicities);
}

} // namespace carving::helper
