// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Betti numbers, of complexes of which they are known.
 */
#include "Homology.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace homology;

namespace
{

std::vector<Simplex> Simplices(const models::TriangleMesh& mesh)
{
  std::vector<Simplex> simplices;
  for (const carving::Triangle& t : mesh.Triangles)
  {
    simplices.emplace_back(t.begin(), t.end());
  }
  return simplices;
}

void ExpectBettiNumbers(
  const std::vector<Simplex>& simplices, const homology::BettiNumbers& expected)
{
  EXPECT_EQ(ComputeBettiNumbers(simplices), expected);
  EXPECT_EQ(ComputeBettiNumbers(simplices, false), expected);
}

} // namespace

// A point, a solid tetrahedron and two of them that share nothing have no tunnels and no voids.
TEST(Homology, OfSimplices)
{
  ExpectBettiNumbers({ { 3 } }, { 1, 0, 0, 0 });
  ExpectBettiNumbers({ { 2, 0, 3, 1 } }, { 1, 0, 0, 0 });
  ExpectBettiNumbers({ { 0, 1, 2, 3 }, { 4, 5, 6, 7 } }, { 2, 0, 0, 0 });
  ExpectBettiNumbers({}, { 0, 0, 0, 0 });
}

// A ring has a tunnel, a sphere a void, a torus a void and two tunnels: one through it, one within
// it.
TEST(Homology, OfSurfaces)
{
  ExpectBettiNumbers({ { 0, 1 }, { 1, 2 }, { 2, 0 } }, { 1, 1, 0, 0 });
  ExpectBettiNumbers(Simplices(models::Sphere(2)), { 1, 0, 1, 0 });
  ExpectBettiNumbers(Simplices(models::Torus(1.0, 0.3, 12, 7)), { 1, 2, 1, 0 });
  ExpectBettiNumbers(Simplices(models::Sheet(4)), { 1, 0, 0, 0 });
}

// Over Z/2 the projective plane, here on six points, has a tunnel and a void.
TEST(Homology, OfTheProjectivePlane)
{
  ExpectBettiNumbers({ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 }, { 0, 5, 1 }, { 1, 2, 4 },
                       { 2, 3, 5 }, { 3, 4, 1 }, { 4, 5, 2 }, { 5, 1, 3 } },
    { 1, 1, 1, 0 });
}

// The boundary of the simplex of five points in four dimensions is a sphere of dimension three.
TEST(Homology, OfASphereOfDimensionThree)
{
  ExpectBettiNumbers(
    { { 0, 1, 2, 3 }, { 0, 1, 2, 4 }, { 0, 1, 3, 4 }, { 0, 2, 3, 4 }, { 1, 2, 3, 4 } },
    { 1, 0, 0, 1 });
}

// Collapses change nothing, whatever the simplices.
TEST(Homology, IsTheSameAfterCollapses)
{
  std::mt19937_64 random(6);
  for (int i = 0; i < 300; ++i)
  {
    std::vector<Simplex> simplices(1 + random() % 25);
    for (Simplex& simplex : simplices)
    {
      const std::size_t corners = 1 + random() % 4;
      while (simplex.size() < corners)
      {
        const int corner = static_cast<int>(random() % 9);
        if (std::find(simplex.begin(), simplex.end(), corner) == simplex.end())
        {
          simplex.push_back(corner);
        }
      }
    }
    EXPECT_EQ(ComputeBettiNumbers(simplices), ComputeBettiNumbers(simplices, false));
  }
}
