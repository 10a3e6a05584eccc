// SPDX-License-Identifier: BSD-3-Clause
#include "Helper/Resolve/Clean.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace carving;
using namespace carving::helper;

// Equal points are merged into the first of them.
TEST(Clean, MergesEqualPoints)
{
  const ResolvedMesh mesh = Clean(
    AsResolved({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } },
      { { 0, 1, 2 }, { 4, 3, 5 } } }));
  EXPECT_EQ(mesh.Points.size(), 4u);
  EXPECT_EQ(mesh.PointSources, (std::vector<int>{ 0, 1, 2, 5 }));
  EXPECT_EQ(mesh.Facets, (std::vector<Triangle>{ { 0, 1, 2 }, { 2, 1, 3 } }));
}

// Zero and negative zero are equal coordinates.
TEST(Clean, TakesMinusZeroForZero)
{
  const ResolvedMesh mesh =
    Clean(AsResolved({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -0.0, 0, 0 }, { 0, 0, 1 } },
      { { 0, 1, 2 }, { 3, 1, 4 } } }));
  EXPECT_EQ(mesh.Points.size(), 4u);
}

// Points that no triangle uses are dropped.
TEST(Clean, DropsUnusedPoints)
{
  const ResolvedMesh mesh =
    Clean(AsResolved({ { { 9, 9, 9 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 1, 2, 3 } } }));
  EXPECT_EQ(mesh.PointSources, (std::vector<int>{ 1, 2, 3 }));
}

// Triangles with equal or collinear corners are dropped, even along a skew line.
TEST(Clean, DropsTrianglesWithoutArea)
{
  const ResolvedMesh mesh =
    Clean(AsResolved({ { { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 }, { 0, 1, 0 } },
      { { 0, 1, 2 }, { 0, 1, 1 }, { 0, 1, 3 } } }));
  EXPECT_EQ(mesh.FacetSources, std::vector<int>{ 2 });
}

// A triangle with the smallest area that doubles can represent is kept.
TEST(Clean, KeepsTheThinnestTriangle)
{
  const double above = std::nextafter(0.5, 1.0);
  EXPECT_EQ(Clean(AsResolved({ { { 0, 0, 0 }, { 1, 1, 0 }, { 0.5, above, 0 } }, { { 0, 1, 2 } } }))
              .Facets.size(),
    1u);
}

// Equal triangles are merged and their multiplicities added.
TEST(Clean, MergesEqualTriangles)
{
  const ResolvedMesh mesh = Clean(AsResolved({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } },
    { { 0, 1, 2 }, { 1, 2, 0 }, { 0, 2, 1 }, { 2, 0, 1 } } }));
  EXPECT_EQ(mesh.Facets, (std::vector<Triangle>{ { 0, 1, 2 } }));
  EXPECT_EQ(mesh.SignedMultiplicities, std::vector<int>{ 2 });
  EXPECT_EQ(mesh.Multiplicities, std::vector<int>{ 4 });
  EXPECT_EQ(mesh.FacetSources, std::vector<int>{ 0 });
}

// Coinciding triangles of opposite orientation stay, with the signed multiplicity 0.
TEST(Clean, KeepsTheSideBetweenGluedBoxes)
{
  const ResolvedMesh mesh = Clean(AsResolved(models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }),
    models::Flipped(models::Box({ 0, 0, 0 }, { 1, 1, 1 })))));
  EXPECT_EQ(mesh.Facets.size(), 12u);
  EXPECT_EQ(mesh.SignedMultiplicities, std::vector<int>(12, 0));
  EXPECT_EQ(mesh.Multiplicities, std::vector<int>(12, 2));
}

// Cleaning a clean mesh changes nothing.
TEST(Clean, LeavesACleanMeshAlone)
{
  const ResolvedMesh once = Clean(AsResolved(models::Torus(1.0, 0.4, 9, 6)));
  const ResolvedMesh twice = Clean(once);
  EXPECT_EQ(once.Points, models::Torus(1.0, 0.4, 9, 6).Points);
  EXPECT_EQ(once.Facets, twice.Facets);
}
