// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The search for the least error bound that leads to a number of vertices.
 */
#include "Helper/Decimation/BoundSearch.h"

#include <gtest/gtest.h>

#include <cmath>

using carving::helper::BoundSearch;

namespace
{

constexpr double Greatest = 3.0;

struct Found
{
  double Bound; ///< the last one
  int Steps;
  bool Reached;
};

/** Searches where the number is reached at `least`, and falls with a power of the bound. */
Found Search(double least, double power)
{
  BoundSearch search(Greatest);
  Found found = { 0.0, 0, false };
  for (std::optional<double> bound = search.First(); bound && !found.Reached; ++found.Steps)
  {
    EXPECT_GT(*bound, found.Bound);
    EXPECT_LE(*bound, Greatest);
    found.Bound = *bound;
    const double excess = std::pow(least / *bound, power);
    found.Reached = excess <= 1.0;
    bound = found.Reached ? std::nullopt : search.Next(*bound, excess);
  }
  return found;
}

} // namespace

// The number is reached in few steps, at a bound that is hardly greater than the least one; more so
// where the number falls much faster than usual.
TEST(BoundSearch, FindsTheLeastBoundInFewSteps)
{
  for (const double power : { 0.6, 0.8, 1.0, 1.5, 2.5 })
  {
    for (double share = 0.45; share < 0.95; share += 0.05)
    {
      const Found found = Search(share * Greatest, power);
      EXPECT_TRUE(found.Reached) << share << " " << power;
      EXPECT_LE(found.Bound, (power > 2.0 ? 1.3 : 1.1) * share * Greatest) << share << " " << power;
      EXPECT_LE(found.Steps, 8) << share << " " << power;
    }
  }
}

// A number that the greatest bound is far from reaching is given up before the greatest bound.
TEST(BoundSearch, GivesUpWithoutHope)
{
  for (const double power : { 1.0, 2.0 })
  {
    const Found found = Search(3.0 * Greatest, power);
    EXPECT_FALSE(found.Reached) << power;
    EXPECT_LT(found.Bound, Greatest) << power;
  }
}

// Without a greatest bound there is a single step without a bound.
TEST(BoundSearch, TakesNoStepsWithoutABound)
{
  BoundSearch search(HUGE_VAL);
  EXPECT_EQ(search.First(), HUGE_VAL);
  EXPECT_EQ(search.Next(HUGE_VAL, 2.0), std::nullopt);
}
