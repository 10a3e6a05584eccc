// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Winding.h"
#include "Helper/Resolve/Clean.h"
#include "Helper/Resolve/FacetNeighbors.h"
#include "Helper/Resolve/Orient.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace carving;
using namespace carving::helper;

namespace
{

/** The mesh with each triangle turned with some probability. */
TriangleMesh WithTurned(TriangleMesh mesh, double share, std::mt19937_64& random)
{
  std::bernoulli_distribution isTurned(share);
  for (Triangle& triangle : mesh.Triangles)
  {
    if (isTurned(random))
    {
      std::swap(triangle[0], triangle[1]);
    }
  }
  return mesh;
}

ResolvedMesh Oriented(const TriangleMesh& mesh)
{
  ResolvedMesh result = Clean(AsResolved(mesh));
  OrientAlike(result);
  return result;
}

} // namespace

// Closed parts in whatever orientation have winding numbers that are integers, of either sign.
TEST(Orient, MakesPartsConsistent)
{
  std::mt19937_64 random(3);
  const TriangleMesh parts =
    models::Joined(models::Sphere(2), models::Moved(models::Torus(1.0, 0.3, 12, 8), { 5, 0, 0 }));
  for (const double share : { 0.1, 0.5, 0.9 })
  {
    const ResolvedMesh mesh = Oriented(WithTurned(parts, share, random));
    EXPECT_TRUE(IsClosed(mesh));
    EXPECT_NEAR(std::abs(WindingNumber(mesh, { 0, 0, 0 })), 1.0, 1e-9);
    EXPECT_NEAR(std::abs(WindingNumber(mesh, { 6, 0, 0 })), 1.0, 1e-9);
    EXPECT_NEAR(WindingNumber(mesh, { 5, 0, 0 }), 0.0, 1e-9);
  }
}

// Of the two orientations, that of more area is kept.
TEST(Orient, KeepsTheOrientationOfMoreArea)
{
  std::mt19937_64 random(4);
  const TriangleMesh sphere = models::Sphere(2);
  EXPECT_NEAR(WindingNumber(Oriented(WithTurned(sphere, 0.2, random)), { 0, 0, 0 }), 1.0, 1e-9);
  EXPECT_NEAR(
    WindingNumber(Oriented(WithTurned(models::Flipped(sphere), 0.2, random)), { 0, 0, 0 }), -1.0,
    1e-9);
}

// A mesh that is oriented consistently stays as it is, whatever the directions of its parts are.
TEST(Orient, LeavesConsistentPartsAlone)
{
  const TriangleMesh mesh =
    models::Joined(models::Sphere(2), models::Flipped(models::Moved(models::Sphere(1), {}, 0.5)));
  EXPECT_EQ(Oriented(mesh).SignedMultiplicities, Clean(AsResolved(mesh)).SignedMultiplicities);
}

// A Klein bottle has one side: nothing is turned.
TEST(Orient, LeavesOneSidedSurfacesAlone)
{
  constexpr int n = 12;
  TriangleMesh bottle = models::Torus(2.0, 0.5, n, n);
  // Of the torus, the last ring is connected to the first one the other way round.
  for (Triangle& t : bottle.Triangles)
  {
    const bool wraps = std::any_of(t.begin(), t.end(), [](int p) { return p / n == n - 1; }) &&
      std::any_of(t.begin(), t.end(), [](int p) { return p / n == 0; });
    for (int& p : t)
    {
      p = wraps && p / n == 0 ? (n - p) % n : p;
    }
  }
  ASSERT_TRUE(Clean(AsResolved(bottle)).Facets.size() == bottle.Triangles.size());
  EXPECT_EQ(Oriented(bottle).SignedMultiplicities, std::vector<int>(bottle.Triangles.size(), 1));
}

// Parts that are open, but for rounding, can share edges with others that touch them: two boxes,
// one on the other, whose sides do not share edges, stay as they are.
TEST(Orient, LeavesOpenPartsAlone)
{
  const TriangleMesh boxes = models::Joined(models::PatchedBox({ 3, 2, 1 }, { 2, 2, 2, 2, 1, 1 }),
    models::Moved(models::PatchedBox({ 3, 2, 1 }, { 1, 1, 1, 1, 2, 2 }), { 0, 0, 1 }));
  const ResolvedMesh given = Clean(AsResolved(boxes));
  const std::vector<FacetNeighbors> neighbors = FindFacetNeighbors(given);
  EXPECT_TRUE(std::any_of(neighbors.begin(), neighbors.end(),
    [](const FacetNeighbors& of) {
      return std::any_of(of.begin(), of.end(), [](const FacetNeighbor& n) { return n.Flipped; });
    }));
  EXPECT_EQ(Oriented(boxes).SignedMultiplicities, given.SignedMultiplicities);
}

// Where four triangles share an edge, there is no telling which two belong together: two closed
// parts with a common edge stay as they are.
TEST(Orient, DoesNotCrossEdgesOfFourTriangles)
{
  const TriangleMesh fan = { { { 0, 0, 0 }, { 0, 0, 1 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 },
                               { -1, -1, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 2, 3 }, { 1, 3, 2 }, //
      { 0, 1, 4 }, { 1, 0, 5 }, { 0, 4, 5 }, { 1, 5, 4 } } };
  TriangleMesh turned = fan;
  std::swap(turned.Triangles[2][0], turned.Triangles[2][1]);
  const ResolvedMesh given = Clean(AsResolved(turned));
  EXPECT_EQ(Oriented(turned).SignedMultiplicities, given.SignedMultiplicities);
  turned.Triangles.resize(4); // one part alone is oriented alike
  EXPECT_NE(Oriented(turned).SignedMultiplicities, Clean(AsResolved(turned)).SignedMultiplicities);
}
