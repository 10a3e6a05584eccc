// SPDX-License-Identifier: BSD-3-Clause
#include "Objects/LeafPlacement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace
{

std::vector<double> Sums(
  const std::vector<double>& costs, const std::vector<int>& places, int numberOfProcesses)
{
  std::vector<double> sums(numberOfProcesses, 0.0);
  for (std::size_t i = 0; i < costs.size(); ++i)
  {
    sums.at(places.at(i)) += costs[i];
  }
  return sums;
}

} // namespace

// Leaves that are spread evenly stay, whatever their order.
TEST(LeafPlacement, LeavesEvenLeavesWhereTheyAre)
{
  const std::vector<int> owners = { 2, 0, 1, 1, 0, 2 };
  EXPECT_EQ(PlaceLeaves({ 5, 7, 3, 4, 1, 2 }, owners, 3), owners);
}

// Leaves move away from a process that has all of them, as many as its share requires.
TEST(LeafPlacement, SpreadsTheLeavesOfOneProcess)
{
  const std::vector<double> costs(200, 1.0);
  const std::vector<int> places = PlaceLeaves(costs, std::vector<int>(200, 1), 4);
  const std::vector<double> sums = Sums(costs, places, 4);
  EXPECT_EQ(sums[1], 55.0); // a tenth more than a quarter
  EXPECT_LE(*std::max_element(sums.begin(), sums.end()), 55.0);
}

// A leaf that costs more than all others stays, and the others move away from its process.
TEST(LeafPlacement, GivesTheLargestLeafAProcessOfItsOwn)
{
  EXPECT_EQ(PlaceLeaves({ 1, 100, 1, 1 }, { 0, 0, 0, 0 }, 2), (std::vector<int>{ 1, 0, 1, 1 }));
}

// A process that takes the least so far gets at most the mean and one leaf more: the others have
// no less.
TEST(LeafPlacement, NoProcessGetsMuchMoreThanItsShare)
{
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i)
  {
    const int processes = 1 + static_cast<int>(random() % 7);
    std::vector<double> costs(random() % 40);
    std::vector<int> owners(costs.size());
    for (std::size_t leaf = 0; leaf < costs.size(); ++leaf)
    {
      costs[leaf] = static_cast<double>(random() % 1000);
      owners[leaf] = static_cast<int>(random() % processes);
    }
    const std::vector<double> sums = Sums(costs, PlaceLeaves(costs, owners, processes), processes);
    const double mean = std::accumulate(costs.begin(), costs.end(), 0.0) / processes;
    const double largest = costs.empty() ? 0.0 : *std::max_element(costs.begin(), costs.end());
    EXPECT_LE(*std::max_element(sums.begin(), sums.end()), std::max(1.1 * mean, mean + largest));
  }
}
