// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Decimation/HeightBound.h"
#include "Helper/Resolve/Clean.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace carving;
using helper::HeightBound;

namespace
{

/** Above the middle of the unit square, at these heights. */
FacetCorners<3> FaceAbove(double a, double b, double c)
{
  return { { { 0.3, 0.3, a }, { 0.7, 0.3, b }, { 0.5, 0.7, c } } };
}

/** The facet of a sheet over the unit square that is closest to the middle. */
int FindMiddle(const ResolvedMesh& sheet)
{
  return FacetTree<3>(sheet).Find({ 0.51, 0.5, 0.0 }).Item;
}

} // namespace

// Above a plane, the highest corner decides.
TEST(HeightBound, IsTheHeightAboveAPlane)
{
  const ResolvedMesh sheet = helper::AsResolved(models::Sheet(20));
  HeightBound heights(sheet);
  const int start = FindMiddle(sheet);
  EXPECT_TRUE(heights.IsWithin(FaceAbove(0.1, 0.1, 0.1), 0.101, start));
  EXPECT_FALSE(heights.IsWithin(FaceAbove(0.1, 0.1, 0.1), 0.099, start));
  EXPECT_FALSE(heights.IsWithin(FaceAbove(0.01, 0.01, 0.1), 0.095, start));
}

// Nothing is known of a face that reaches beyond the border of the mesh, nor above a hole, although
// all facets below are close.
TEST(HeightBound, EndsWithTheSheet)
{
  ResolvedMesh sheet = helper::AsResolved(models::Sheet(20));
  const int start = FindMiddle(sheet);
  const FacetCorners<3> beyond = { { { 0.3, 0.3, 0.01 }, { 1.3, 0.3, 0.01 }, { 0.5, 0.7, 0.01 } } };
  EXPECT_FALSE(HeightBound(sheet).IsWithin(beyond, 0.1, start));

  const FacetCorners<3> above = FaceAbove(0.01, 0.01, 0.01);
  EXPECT_TRUE(HeightBound(sheet).IsWithin(above, 0.1, start));
  const int hole = FacetTree<3>(sheet).Find({ 0.46, 0.43, 0.0 }).Item;
  ASSERT_NE(hole, start);
  sheet.Facets[hole] = sheet.Facets[0];
  EXPECT_FALSE(HeightBound(sheet).IsWithin(above, 0.1, start));
}

// Nothing is known of a face larger than the top of a thin box: facets turn over at its border.
TEST(HeightBound, EndsAtFolds)
{
  const ResolvedMesh box = helper::AsResolved(models::Box({ 0, 0, -0.01 }, { 1, 1, 0 }));
  const int top = FacetTree<3>(box).Find({ 0.5, 0.51, 1.0 }).Item;
  HeightBound heights(box);
  EXPECT_TRUE(heights.IsWithin(FaceAbove(0.01, 0.01, 0.01), 0.1, top));
  const FacetCorners<3> larger = { { { 0.5, 0.3, 0.01 }, { 1.2, 0.5, 0.01 }, { 0.5, 0.7, 0.01 } } };
  EXPECT_FALSE(heights.IsWithin(larger, 0.1, top));
}

// A facet that is not below the face shows nothing, nor does a face without an area.
TEST(HeightBound, BeginsBelowTheFace)
{
  const ResolvedMesh sheet = helper::AsResolved(models::Sheet(20));
  HeightBound heights(sheet);
  EXPECT_FALSE(heights.IsWithin(FaceAbove(0.01, 0.01, 0.01), 0.1, 0));
  const FacetCorners<3> line = { { { 0.3, 0.3, 0.01 }, { 0.5, 0.5, 0.01 }, { 0.7, 0.7, 0.01 } } };
  EXPECT_FALSE(heights.IsWithin(line, 0.1, FindMiddle(sheet)));
}

// No point of a face that is within a bound is farther from the mesh, as the distances of a grid of
// points show. Of random faces near a bumpy surface, both answers are common.
TEST(HeightBound, HoldsForAllPointsOfRandomFaces)
{
  const TriangleMesh mesh = models::BumpyTorus(600);
  const ResolvedMesh surface = helper::AsResolved(mesh);
  HeightBound heights(surface);
  const FacetTree<3> tree(surface);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int within = 0, unknown = 0;
  for (int i = 0; i < 200; ++i)
  {
    SCOPED_TRACE("face " + std::to_string(i));
    const Point& around = mesh.Points[random() % mesh.Points.size()];
    FacetCorners<3> face;
    for (Point& corner : face)
    {
      for (int k = 0; k < 3; ++k)
      {
        corner[k] = around[k] + 0.2 * share(random);
      }
    }
    const int start = tree.Find((face[0] + face[1] + face[2]) / 3.0).Item;
    const double bound = 0.3 * (1.0 + share(random));
    if (!heights.IsWithin(face, bound, start))
    {
      ++unknown;
      continue;
    }
    ++within;
    EXPECT_LE(checks::FarthestOfGrid(mesh.Points, mesh.Triangles, face), bound * (1.0 + 1e-9));
  }
  EXPECT_GT(within, 30);
  EXPECT_GT(unknown, 30);
}
