// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How far approximations are from the mesh.
 */
#include "Core/Measure/StreamError.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/FaceDistance.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Core/Stream/Level.h"
#include "Shapes.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace carving;

namespace
{

std::vector<double> Errors(const StoredStream<3>& stream)
{
  std::vector<double> errors;
  EXPECT_TRUE(ComputeErrors<3>(stream, stream.Mesh.Surface, true, errors));
  return errors;
}

/** The farthest of many points of a level, found by looking at all facets of M. */
double SampleError(const StoredStream<3>& stream, int step)
{
  constexpr int n = 40;
  const std::vector<Point>& points = stream.Mesh.Surface.Points;
  double farthest = 0.0;
  for (const auto& [a, b, c] : small::Triangles(ExtractLevel(stream, step)))
  {
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; i + j <= n; ++j)
      {
        const Point p = (i * points[a] + j * points[b] + (n - i - j) * points[c]) / n;
        double closest = HUGE_VAL;
        for (const Triangle& facet : stream.Mesh.Surface.Facets)
        {
          closest = std::min(closest, DistanceTo(CornersOf<3>(points, facet), p));
        }
        farthest = std::max(farthest, closest);
      }
    }
  }
  return farthest;
}

/** A triangle in and around the torus of the tests. */
FacetCorners<3> RandomFace(std::mt19937_64& random)
{
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  FacetCorners<3> face;
  for (Point& corner : face)
  {
    corner = { coordinate(random), coordinate(random), coordinate(random) };
  }
  return face;
}

} // namespace

// A face that lies across a finely divided plane, except for roundings, soon gets a final bound,
// which is negligible.
TEST(FaceDistance, IsNegligibleAcrossAPlane)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> rounding(-1e-8, 1e-8);
  TriangleMesh mesh = models::Sheet(12);
  for (Point& p : mesh.Points)
  {
    p[2] += rounding(random);
  }
  ResolvedMesh sheet;
  sheet.Points = mesh.Points;
  sheet.Facets = mesh.Triangles;
  const FaceDistance<3> distance(sheet);
  const FacetCorners<3> face = { mesh.Points.front(), mesh.Points[2], mesh.Points.back() };
  const auto bound = distance.Compute(face, 100000);
  EXPECT_TRUE(bound.Final);
  EXPECT_LE(bound.Upper, 1e-6 * Diagonal(mesh.Points));
}

// Of a tetrahedron around a smaller one a corner is the farthest, since distance is convex: here
// (8, 0, 0), which is closest to (3.5, 1.5, 1.5). M itself is at no distance.
TEST(StreamError, IsKnownOfNestedTetrahedra)
{
  const auto errors = Errors(small::StoreOneByOne(small::NestedTetrahedra(small::InnerFaces())));
  const double expected = std::sqrt(4.5 * 4.5 + 2 * 1.5 * 1.5);
  EXPECT_GE(errors.front(), expected * (1.0 - 1e-12));
  EXPECT_LE(errors.front(), expected * 1.01);
  EXPECT_EQ(errors.back(), 0.0);
}

// At every step the distance is that of the farthest of many points, to one hundredth.
TEST(StreamError, AgreesWithManyPoints)
{
  const auto inner = small::InnerFaces();
  for (const Tetrahedralization& mesh : { small::Row(6), small::NestedTetrahedra(inner),
         small::NestedTetrahedra({ inner[0] }), small::NestedTetrahedra({ inner[1], inner[2] }) })
  {
    const StoredStream<3> stream = small::StoreOneByOne(mesh);
    const std::vector<double> errors = Errors(stream);
    ASSERT_EQ(errors.size(), stream.Order.StepPriority.size());
    for (std::size_t step = 0; step < errors.size(); ++step)
    {
      const double sampled = SampleError(stream, static_cast<int>(step));
      EXPECT_GE(errors[step], sampled - 1e-12); // points of M are rounded off it
      // Edges are at most 8 sqrt(2) long: no point is farther than this from one of the many.
      EXPECT_LE(errors[step], 1.01 * (sampled + 8.0 * std::sqrt(2.0 / 3.0) / 40));
    }
  }
}

// A face that is close above many triangles in one plane needs few queries.
TEST(FaceDistance, BoundsAFaceAboveAPlane)
{
  const models::TriangleMesh sheet = models::Sheet(16);
  ResolvedMesh mesh;
  mesh.Points = sheet.Points;
  mesh.Facets = sheet.Triangles;
  const double size = Diagonal(mesh.Points), height = 1e-6 * size;
  const auto [lower, upper] = BoxAround(mesh.Points);
  FacetCorners<3> face = { lower, { upper[0], lower[1], lower[2] }, upper };
  for (Point& corner : face)
  {
    corner[2] += height;
  }
  const auto bound = FaceDistance<3>(mesh).Compute(face, 20000);
  EXPECT_TRUE(bound.Final);
  EXPECT_GE(bound.Upper, height * (1.0 - 1e-6));
  EXPECT_LE(bound.Upper, height * 1.01);
}

// The bounds of a face enclose the distance of its farthest point, or say that this is close
// enough.
TEST(FaceDistance, EnclosesTheFarthestOfManyPoints)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> closeEnough(0.0, 1.0);
  const ResolvedMesh mesh = small::Resolved(models::Torus(1.0, 0.4, 20, 10));
  const FaceDistance<3> distance(mesh);
  for (int i = 0; i < 200; ++i)
  {
    const FacetCorners<3> face = RandomFace(random);
    constexpr int n = 60;
    double sampled = 0.0;
    for (int j = 0; j <= n; ++j)
    {
      for (int k = 0; j + k <= n; ++k)
      {
        const double u = 1.0 * j / n, v = 1.0 * k / n;
        sampled =
          std::max(sampled, distance.OfPoint((1.0 - u - v) * face[0] + u * face[1] + v * face[2]));
      }
    }
    // No point of the face is farther from one of the samples.
    const double greatest = sampled + BallRadius<3>(face) / n;
    const double enough = i % 2 == 0 ? 0.0 : closeEnough(random);
    const auto bound = distance.Compute(face, 100000, enough);
    EXPECT_LE(bound.Lower, greatest);
    EXPECT_GE(bound.Upper, sampled * (1.0 - 1e-12));
    EXPECT_LE(bound.Upper, std::max(enough, 1.01 * greatest));
  }
}

// A point beyond a bound is found where there is one, and not where there is none.
TEST(FaceDistance, FindsWhatIsFartherThanABound)
{
  std::mt19937_64 random(8);
  const ResolvedMesh mesh = small::Resolved(models::Torus(1.0, 0.4, 20, 10));
  const FaceDistance<3> distance(mesh);
  std::uniform_int_distribution<int> anyFacet(0, static_cast<int>(mesh.Facets.size()) - 1);
  for (int i = 0; i < 200; ++i)
  {
    const FacetCorners<3> face = RandomFace(random);
    const FacetCorners<3> nearby = distance.GetTree().GetItems().CornersOf(anyFacet(random));
    constexpr long long manyQueries = 100000;
    const auto bound = distance.Compute(face, manyQueries);
    ASSERT_TRUE(bound.Final);
    long long queries = manyQueries;
    EXPECT_EQ(distance.FindFarther({ face }, 1.01 * bound.Upper, queries, nearby), 0.0);
    EXPECT_GT(queries, 0);
    EXPECT_LT(queries, manyQueries);
    const double below = 0.99 * bound.Lower;
    const double farther = distance.FindFarther({ face }, below, queries, nearby);
    EXPECT_GT(farther, below);
    EXPECT_LE(farther, bound.Upper);
    // The bound, if one query is too few.
    queries = 1;
    EXPECT_GE(distance.FindFarther({ face }, below, queries, nearby), below);
    EXPECT_EQ(queries, 0);
  }
}

// The tree finds what looking at all facets finds, from near and far, wherever it begins; or a
// facet that is close enough.
TEST(FacetTree, FindsTheClosest)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  std::uniform_int_distribution<int> anyFacet(0, 399);
  const ResolvedMesh mesh = small::Resolved(models::Torus(1.0, 0.4, 20, 10));
  const FacetTree<3> tree(mesh);
  ASSERT_EQ(mesh.Facets.size(), 400u);
  for (int i = 0; i < 1000; ++i)
  {
    const Point p = { coordinate(random), coordinate(random), coordinate(random) };
    double closest = HUGE_VAL;
    for (const Triangle& facet : mesh.Facets)
    {
      closest = std::min(closest, DistanceTo(CornersOf<3>(mesh.Points, facet), p));
    }
    const auto found = tree.Find(p);
    EXPECT_EQ(found.Distance, closest);
    EXPECT_EQ(DistanceTo(CornersOf<3>(mesh.Points, mesh.Facets[found.Item]), p), closest);
    const int nearby = anyFacet(random);
    EXPECT_EQ(tree.Find(p, 0.0, nearby).Distance, closest);
    EXPECT_EQ(tree.Find(p, 0.999 * closest, nearby).Distance, closest);
    EXPECT_LE(tree.Find(p, 1.1 * closest, nearby).Distance, 1.1 * closest);
  }
}

// A point is closest to the inside of a triangle, to a side or to a corner of it.
TEST(FacetTree, MeasuresTrianglesAndEdges)
{
  const FacetCorners<3> triangle = { { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } } };
  EXPECT_DOUBLE_EQ(DistanceTo(triangle, { 1, 1, -2 }), 2.0);
  EXPECT_DOUBLE_EQ(DistanceTo(triangle, { 2, -3, 4 }), 5.0);
  EXPECT_DOUBLE_EQ(DistanceTo(triangle, { 4, 4, 0 }), std::sqrt(8.0));
  EXPECT_DOUBLE_EQ(DistanceTo(triangle, { 6, -1, 2 }), 3.0);
  const FacetCorners<2> edge = { { { 0, 0, 0 }, { 4, 0, 0 } } };
  EXPECT_DOUBLE_EQ(DistanceTo(edge, { 1, 3, 0 }), 3.0);
  EXPECT_DOUBLE_EQ(DistanceTo(edge, { 7, 4, 0 }), 5.0);
}
