// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/Priority.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace carving;

namespace
{

double Measure(const std::vector<Point>& points, PriorityMeasure measure)
{
  return ComputePriorities(small::Assemble(points, { { 0, 1, 2, 3 } }, {}), measure)[0];
}

/** The corner of a unit cube: l = sqrt 2, v = 1/6, r = half the cube's diagonal. */
const std::vector<Point> Corner = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

} // namespace

// The measures of the corner of a cube that do not depend on the mesh are known.
TEST(Priority, OfACubesCornerIsKnown)
{
  const double l = std::sqrt(2.0), v = 1.0 / 6.0;
  EXPECT_NEAR(Measure(Corner, PriorityMeasure::LongestEdge), l, 1e-15);
  EXPECT_NEAR(Measure(Corner, PriorityMeasure::Volume), v, 1e-15);
  EXPECT_NEAR(Measure(Corner, PriorityMeasure::Circumradius), std::sqrt(3.0) / 2.0, 1e-15);
  EXPECT_NEAR(Measure(Corner, PriorityMeasure::EdgeVolume), std::sqrt(l * std::cbrt(v)), 1e-15);
}

// The distance of the centroid counts from the nearest triangle of M.
TEST(Priority, TakesTheDistanceFromTheMesh)
{
  // The corner's base: the centroid is a quarter of the height above it.
  const auto mesh = small::Assemble(Corner, { { 0, 1, 2, 3 } }, { { 0, 2, 1 } });
  EXPECT_NEAR(ComputePriorities(mesh, PriorityMeasure::EdgeDistance, 2)[0],
    std::cbrt(std::sqrt(2.0) / 16.0), 1e-15);
}

// All measures are finite for a flat tetrahedron, even one on a line; the radius is then the
// diagonal.
TEST(Priority, IsFiniteForFlatTetrahedra)
{
  const std::vector<std::vector<Point>> flat = {
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } },
    { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 }, { 3, 3, 3 } },
  };
  for (const std::vector<Point>& points : flat)
  {
    EXPECT_EQ(Measure(points, PriorityMeasure::Volume), 0.0);
    EXPECT_EQ(Measure(points, PriorityMeasure::Circumradius), Diagonal(points));
    EXPECT_EQ(Measure(points, PriorityMeasure::EdgeVolume), 0.0);
    EXPECT_EQ(Measure(points, PriorityMeasure::EdgeDistance), 0.0); // there is no mesh
  }
}

// As lengths, the measures double when the mesh does.
TEST(Priority, ScalesAsALength)
{
  std::vector<Point> doubled = Corner;
  for (Point& p : doubled)
  {
    for (double& x : p)
    {
      x *= 2.0;
    }
  }
  for (const auto measure : { PriorityMeasure::LongestEdge, PriorityMeasure::Volume,
         PriorityMeasure::Circumradius, PriorityMeasure::EdgeVolume })
  {
    EXPECT_NEAR(PriorityAsLength<3>(Measure(doubled, measure), measure),
      2.0 * PriorityAsLength<3>(Measure(Corner, measure), measure), 1e-12);
  }
}
