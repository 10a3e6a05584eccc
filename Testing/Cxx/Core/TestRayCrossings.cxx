// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/RayCrossings.h"
#include "Core/Solid/Winding.h"
#include "Shapes.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

using namespace carving;
using small::Resolved;

namespace
{

using Counts = std::array<int, 2>;

/** The parities of the numbers of triangles that both rays cross. */
Counts ParitiesOf(const Counts& counts)
{
  return { counts[0] % 2, counts[1] % 2 };
}

} // namespace

// A ray leaves each of several shells around its start once, and crosses others twice or not at
// all.
TEST(RayCrossings, CountShells)
{
  const auto shell = [](double radius) { return models::Moved(models::Sphere(2), {}, radius); };
  const ResolvedMesh mesh = Resolved(models::Joined(shell(1.0),
    models::Joined(
      shell(2.0), models::Joined(shell(3.0), models::Moved(models::Sphere(2), { 9, 1, 2 })))));
  const RayCrossings crossings(mesh);
  EXPECT_EQ(ParitiesOf(crossings.Count({ 0.01, 0.02, 0.03 })), (Counts{ 1, 1 }));
  EXPECT_EQ(ParitiesOf(crossings.Count({ 1.51, 0.02, 0.03 })), (Counts{ 0, 0 }));
  EXPECT_EQ(ParitiesOf(crossings.Count({ 2.51, 0.02, 0.03 })), (Counts{ 1, 1 }));
  EXPECT_EQ(ParitiesOf(crossings.Count({ 4.01, 0.02, 0.03 })), (Counts{ 0, 0 }));
  EXPECT_EQ(crossings.Count({ -9.0, -9.0, 9.0 }), (Counts{ 0, 0 }));
}

// Copies of triangles count.
TEST(RayCrossings, CountCopies)
{
  ResolvedMesh mesh = Resolved(models::Sphere(1));
  mesh.Multiplicities.assign(mesh.Facets.size(), 3);
  EXPECT_EQ(RayCrossings(mesh).Count({ 0.1, 0.2, 0.3 }), (Counts{ 3, 3 }));
}

// Inside and outside of a torus, the parity is that of the winding number.
TEST(RayCrossings, AgreeWithWindings)
{
  const ResolvedMesh mesh = Resolved(models::Torus(1.0, 0.4, 40, 20));
  const RayCrossings crossings(mesh);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  int inside = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Point p = { uniform(random), uniform(random), uniform(random) / 3.0 };
    const int winding = static_cast<int>(std::lround(WindingNumber(mesh, p)));
    EXPECT_EQ(ParitiesOf(crossings.Count(p)), (Counts{ winding % 2, winding % 2 }));
    inside += winding != 0;
  }
  EXPECT_GT(inside, 100);
}

// The rays from inside a surface with a hole cross different numbers of triangles somewhere.
TEST(RayCrossings, DifferWhereTheMeshIsOpen)
{
  TriangleMesh sphere = models::Sphere(2);
  sphere.Triangles.resize(sphere.Triangles.size() / 2);
  const ResolvedMesh mesh = Resolved(sphere);
  const RayCrossings crossings(mesh);
  int different = 0;
  for (int i = 0; i < 100; ++i)
  {
    const double x = 0.015 * i - 0.75;
    const Counts parities = ParitiesOf(crossings.Count({ x, 0.011, 0.017 }));
    different += parities[0] != parities[1];
  }
  EXPECT_GT(different, 0);
}
