// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The bound of the distance of faces that collapses make, the search for the least one that leads
 * to a number of vertices, and when a number is given up.
 */
#include "Helper/Decimation/BoundSearch.h"
#include "Helper/Decimation/ErrorBound.h"
#include "Helper/Decimation/Hope.h"
#include "Helper/Resolve/Clean.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace carving;
using helper::BoundSearch;
using helper::SurfaceMesh;
using helper::Vertex;

namespace
{

/** A tetrahedron as M and as the surface around M, and the star of the edge up the z-axis. */
class StarWithBound : public testing::Test
{
protected:
  const ResolvedMesh M = helper::AsResolved(models::Tetrahedron());
  const SurfaceMesh Surface = helper::AsSurfaceMesh(this->M);
  const helper::HalfEdge HalfEdge = this->Surface.halfedge(Vertex(0), Vertex(3));
  const SurfaceMesh::Edge_index Edge = this->Surface.edge(this->HalfEdge);
  const helper::Star Star{ this->Surface, this->HalfEdge };
  const FaceDistance<3> FromM{ this->M };
  helper::ErrorBound Bound{ this->FromM, this->Surface.num_edges() };
};

constexpr double Greatest = 3.0;

struct Found
{
  double Bound; ///< the last one
  int Steps;
  bool Reached;
};

/**
 * Searches where the number is reached at `least`, and falls with a power of the bound. `own` is
 * the error of the surface as given.
 */
Found Search(double least, double power, double own = 0.0)
{
  BoundSearch search(Greatest, own);
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

// The bound never falls.
TEST_F(StarWithBound, OnlyRises)
{
  EXPECT_TRUE(this->Bound.Raise(0.5));
  EXPECT_FALSE(this->Bound.Raise(0.3));
  EXPECT_EQ(this->Bound.Get(), 0.5);
}

// Only faces within the bound are allowed.
TEST_F(StarWithBound, AllowsFacesWithin)
{
  this->Bound.Raise(0.5);
  EXPECT_TRUE(this->Bound.Allows(this->Star, { 0, 0, 1.4 }));
  EXPECT_FALSE(this->Bound.Allows(this->Star, { 0, 0, 1.6 }));
}

// An edge waits for a bound above the distance that was in the way, or is forgotten.
TEST_F(StarWithBound, SparesAttemptsThatWouldFail)
{
  this->Bound.Raise(0.5);
  EXPECT_TRUE(this->Bound.MayAllow(this->Edge));
  EXPECT_FALSE(this->Bound.Allows(this->Edge, this->Star, { 0, 0, 2 })); // 1 from M
  EXPECT_FALSE(this->Bound.Allows(this->Edge, this->Star, { 0, 0, 3 }));
  EXPECT_FALSE(this->Bound.MayAllow(this->Edge));
  this->Bound.Raise(0.9);
  EXPECT_FALSE(this->Bound.MayAllow(this->Edge));
  this->Bound.Forget(this->Edge);
  EXPECT_TRUE(this->Bound.MayAllow(this->Edge));
  EXPECT_FALSE(this->Bound.Allows(this->Edge, this->Star, { 0, 0, 2 }));
  this->Bound.Raise(1.1);
  EXPECT_TRUE(this->Bound.MayAllow(this->Edge));
}

// The number is reached in few steps, at a bound that is hardly greater than the least one. The
// first step goes farther beyond where the number falls much faster than usual.
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

// The search begins just above the error of the surface as given: below that, edges would be kept.
TEST(BoundSearch, BeginsAboveTheErrorOfTheGivenSurface)
{
  for (double share = 0.5; share <= 1.0; share += 0.1)
  {
    const std::optional<double> first = BoundSearch(Greatest, share * Greatest).First();
    ASSERT_TRUE(first);
    EXPECT_GE(*first, share * Greatest);
    EXPECT_LE(*first, std::min(1.05 * share, 1.0) * Greatest);
    EXPECT_TRUE(Search(0.9 * share * Greatest, 1.0, share * Greatest).Reached);
  }
}

// A surface that is farther than the greatest bound as it is given has no bound to begin with.
TEST(BoundSearch, GivesUpSurfacesThatAreTooFar)
{
  EXPECT_EQ(BoundSearch(Greatest, 1.1 * Greatest).First(), std::nullopt);
}

// Without a greatest bound there is a single step without a bound.
TEST(BoundSearch, TakesNoStepsWithoutABound)
{
  BoundSearch search(HUGE_VAL, 0.0);
  EXPECT_EQ(search.First(), HUGE_VAL);
  EXPECT_EQ(search.Next(HUGE_VAL, 2.0), std::nullopt);
}

// A number far from reach is given up after many attempts, unless few vertices are left.
TEST(Hope, RemainsWithFewVertices)
{
  constexpr int many = 100000;
  Hope large(1000.0), small(30.0);
  bool largeGoesOn = true, smallGoesOn = true;
  for (int attempt = 0; attempt < many; ++attempt)
  {
    largeGoesOn = large.GoesOn(2000.0);
    smallGoesOn = smallGoesOn && small.GoesOn(60.0);
  }
  EXPECT_FALSE(largeGoesOn);
  EXPECT_TRUE(smallGoesOn);
}
