// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Winding.h"
#include "Core/Solid/WindingTree.h"
#include "Shapes.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <random>

using namespace carving;

namespace
{

/** Triangles of many sizes and windings anywhere in the unit cube. */
ResolvedMesh RandomSoup(std::mt19937& random, int numberOfTriangles)
{
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  std::uniform_int_distribution<int> winding(-2, 2);
  ResolvedMesh mesh;
  for (int t = 0; t < numberOfTriangles; ++t)
  {
    const double size = std::pow(coordinate(random), 4.0);
    const Point at = { coordinate(random), coordinate(random), coordinate(random) };
    for (int i = 0; i < 3; ++i)
    {
      mesh.Points.push_back({ at[0] + size * coordinate(random), at[1] + size * coordinate(random),
        at[2] + size * coordinate(random) });
    }
    mesh.Facets.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
    mesh.SignedMultiplicities.push_back(winding(random));
  }
  return mesh;
}

double LargestError(const ResolvedMesh& mesh, std::mt19937& random, int numberOfPoints)
{
  std::uniform_real_distribution<double> coordinate(-0.5, 1.5);
  const WindingTree tree(mesh);
  double largest = 0.0;
  for (int i = 0; i < numberOfPoints; ++i)
  {
    const Point point = { coordinate(random), coordinate(random), coordinate(random) };
    largest = std::max(largest, std::abs(tree.Measure(point) - WindingNumber(mesh, point)));
  }
  return largest;
}

} // namespace

// The sum over a tree comes close to the sum over all triangles, near them, among them and far
// away.
TEST(WindingTree, ComesCloseToTheSumOverAllTriangles)
{
  std::mt19937 random(3);
  for (const int size : { 1, 7, 50, 400, 3000 })
  {
    EXPECT_LT(LargestError(RandomSoup(random, size), random, 300), 0.02) << size << " triangles";
  }
}

// The error does not grow with the number of triangles.
TEST(WindingTree, StaysCloseForAFineMesh)
{
  std::mt19937 random(4);
  const TriangleMesh sphere = models::Moved(models::Sphere(5), { 0.5, 0.5, 0.5 }, 0.4);
  ResolvedMesh mesh = small::Resolved(sphere);
  mesh.Facets.resize(mesh.Facets.size() / 2);
  EXPECT_LT(LargestError(mesh, random, 300), 0.02);
}

// Where a threshold is near, nothing is left out.
TEST(WindingTree, IsExactNearAThreshold)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  const ResolvedMesh mesh = RandomSoup(random, 2000);
  const WindingTree tree(mesh);
  for (int i = 0; i < 100; ++i)
  {
    const Point point = { coordinate(random), coordinate(random), coordinate(random) };
    const double exact = WindingNumber(mesh, point);
    const double threshold = std::abs(exact - std::round(exact));
    EXPECT_EQ(tree.Measure(point, { 0.77, threshold }), exact);
  }
}

// Where copies cancel, and where there is no triangle, nothing winds.
TEST(WindingTree, OfNothingIsZero)
{
  ResolvedMesh mesh;
  EXPECT_EQ(WindingTree(mesh).Measure({ 0, 0, 0 }), 0.0);
  std::mt19937 random(6);
  mesh = RandomSoup(random, 10);
  mesh.SignedMultiplicities.assign(10, 0);
  EXPECT_EQ(WindingTree(mesh).Measure({ 0.5, 0.5, 0.5 }), 0.0);
}
