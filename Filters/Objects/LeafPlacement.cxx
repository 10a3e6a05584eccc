// SPDX-License-Identifier: BSD-3-Clause
#include "Objects/LeafPlacement.h"

#include <algorithm>
#include <numeric>

std::vector<int> PlaceLeaves(
  const std::vector<double>& costs, const std::vector<int>& owners, int numberOfProcesses)
{
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), 0);
  // The last leaves even out the sums best if they are the smallest.
  std::stable_sort(order.begin(), order.end(),
    [&costs](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
  const double share = std::accumulate(costs.begin(), costs.end(), 0.0) / numberOfProcesses;
  // Moving a leaf for less than a tenth gains less than it takes.
  const double limit = std::max(1.1 * share, costs.empty() ? 0.0 : costs[order.front()]);
  std::vector<double> sums(numberOfProcesses, 0.0);
  std::vector<int> places(costs.size());
  for (const std::size_t leaf : order)
  {
    int place = owners[leaf];
    if (sums[place] + costs[leaf] > limit)
    {
      const auto least = std::min_element(sums.begin(), sums.end());
      place = *least < sums[place] ? static_cast<int>(least - sums.begin()) : place;
    }
    places[leaf] = place;
    sums[place] += costs[leaf];
  }
  return places;
}
