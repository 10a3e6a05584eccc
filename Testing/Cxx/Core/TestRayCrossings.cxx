// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/RayCrossings.h"
#include "Core/Solid/Winding.h"
#include "Shapes.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace carving;
using small::Resolved;

// A ray leaves each of several shells around its start once, and crosses others twice or not at all.
TEST(RayCrossings, CountShells)
{
  const auto shell = [](double radius) { return models::Moved(models::Sphere(2), {}, radius); };
  const ResolvedMesh mesh = Resolved(models::Joined(shell(1.0),
    models::Joined(
      shell(2.0), models::Joined(shell(3.0), models::Moved(models::Sphere(2), { 9, 1, 2 })))));
  const RayCrossings crossings(mesh);
  EXPECT_EQ(crossings.Count({ 0.01, 0.02, 0.03 }) % 2, 1);
  EXPECT_EQ(crossings.Count({ 1.51, 0.02, 0.03 }) % 2, 0);
  EXPECT_EQ(crossings.Count({ 2.51, 0.02, 0.03 }) % 2, 1);
  EXPECT_EQ(crossings.Count({ 4.01, 0.02, 0.03 }) % 2, 0);
  EXPECT_EQ(crossings.Count({ -9.0, -9.0, 9.0 }), 0);
}

// Copies of triangles count.
TEST(RayCrossings, CountCopies)
{
  ResolvedMesh mesh = Resolved(models::Sphere(1));
  mesh.Multiplicities.assign(mesh.Facets.size(), 3);
  EXPECT_EQ(RayCrossings(mesh).Count({ 0.1, 0.2, 0.3 }), 3);
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
    const long winding = std::lround(WindingNumber(mesh, p));
    EXPECT_EQ(crossings.Count(p) % 2, winding % 2);
    inside += winding != 0;
  }
  EXPECT_GT(inside, 100);
}
