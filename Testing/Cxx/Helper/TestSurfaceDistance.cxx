// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/SurfaceDistance.h"
#include "Helper/Resolve/Clean.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace carving;
using namespace carving::helper;

// Above a plane, the highest corner is the farthest point.
TEST(SurfaceDistance, IsTheHeightAboveAPlane)
{
  const ResolvedMesh plane =
    AsResolved({ { { -9, -9, 0 }, { 9, -9, 0 }, { 0, 9, 0 } }, { { 0, 1, 2 } } });
  SurfaceDistance distance(plane);
  const SurfaceDistance::Corners triangle = { { { 0, 0, 0.1 }, { 1, 0, 0.2 }, { 0, 1, 0.5 } } };
  EXPECT_NEAR(distance.Farthest(triangle, 1e-3), 0.5, 0.05 * 0.5);
  EXPECT_EQ(distance.Farthest(triangle, 0.7), 0.7);
  EXPECT_TRUE(distance.IsWithin(triangle, 0.53));
  EXPECT_FALSE(distance.IsWithin(triangle, 0.47));
}

// The farthest point may be in the interior: a triangle that spans a gap is farthest in its middle.
TEST(SurfaceDistance, IsFoundInTheMiddleOfATriangle)
{
  std::mt19937_64 random(5);
  const auto draw = [&random] { return static_cast<double>(random() % 2001) / 1000.0 - 1.0; };
  const auto drawPoint = [&draw] { return Point{ draw(), draw(), draw() }; };
  for (int i = 0; i < 30; ++i)
  {
    SCOPED_TRACE("triangle " + std::to_string(i));
    // Small triangles of M at the corners of the triangle and elsewhere.
    SurfaceDistance::Corners triangle;
    TriangleMesh mesh;
    for (int k = 0; k < 6; ++k)
    {
      const Point at = drawPoint();
      if (k < 3)
      {
        triangle[k] = at;
      }
      const int first = static_cast<int>(mesh.Points.size());
      mesh.Points.push_back(at);
      mesh.Points.push_back(at + 0.1 * drawPoint());
      mesh.Points.push_back(at + 0.1 * drawPoint());
      mesh.Triangles.push_back({ first, first + 1, first + 2 });
    }
    const double expected = checks::FarthestOfGrid(mesh.Points, mesh.Triangles, triangle);
    const ResolvedMesh surface = AsResolved(mesh);
    SurfaceDistance distance(surface);
    // The grid underestimates the distance by less than its spacing.
    const double spacing = 4.0 / 40.0;
    const double farthest = distance.Farthest(triangle, 1e-3);
    EXPECT_GE(1.05 * farthest, expected);
    EXPECT_LE(farthest, expected + spacing);
    EXPECT_FALSE(distance.IsWithin(triangle, expected / 1.06));
    EXPECT_TRUE(distance.IsWithin(triangle, expected + spacing));
  }
}
