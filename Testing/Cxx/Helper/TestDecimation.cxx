// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decimation of closed surfaces.
 */
#include "Checks.h"
#include "Core/Mesh/Vector.h"
#include "DecimationChecks.h"
#include "Helper/Decimation/EnclosingDecimation.h"
#include "RealMeshes.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace carving;
using helper::DecimateEnclosing;

namespace
{

/** The largest distance of the corners and of a random point of each triangle from a mesh. */
double MeasureFarthest(
  const TriangleMesh& surface, const TriangleMesh& mesh, std::mt19937_64& random)
{
  double farthest = 0.0;
  const auto measure = [&](const Point& p)
  { farthest = std::max(farthest, checks::DistanceTo(mesh.Points, mesh.Triangles, p)); };
  std::for_each(surface.Points.begin(), surface.Points.end(), measure);
  for (const Triangle& t : surface.Triangles)
  {
    measure(RandomPointOn(surface, t, random));
  }
  return farthest;
}

} // namespace

// Every result has at most as many vertices as its target, encloses the surface and does not cross
// itself.
TEST(Decimation, EnclosesSimpleShapes)
{
  std::mt19937_64 random(1);
  for (const TriangleMesh& mesh :
    { models::Sphere(3), models::Torus(1.0, 0.3, 32, 16), models::Box({ 0, 0, 0 }, { 1, 2, 3 }),
      models::Joined(models::Sphere(2), models::Moved(models::Sphere(2), { 2.5, 0, 0 })) })
  {
    for (const bool nested : { false, true })
    {
      const auto results = Decimate(mesh, { 200, 60, 30 }, nested);
      ASSERT_EQ(results.size(), 3u);
      for (std::size_t i = 0; i < results.size(); ++i)
      {
        EXPECT_LE(results[i].Mesh.Points.size(), i == 0 ? 200u : i == 1 ? 60u : 30u);
        EXPECT_TRUE(results[i].Reached);
        ExpectEnclosingSurface(mesh, results[i], random);
      }
    }
  }
}

// A void stays a void, with solid around it, however far it shrinks.
TEST(Decimation, KeepsVoids)
{
  std::mt19937_64 random(7);
  const TriangleMesh hollow =
    models::Joined(models::Sphere(2), models::Flipped(models::Moved(models::Sphere(2), {}, 0.5)));
  for (const bool nested : { false, true })
  {
    for (const DecimationResult& result : Decimate(hollow, { 100, 40, 8 }, nested))
    {
      ExpectEnclosingSurface(hollow, result, random);
    }
  }
}

// Every nested result lies inside all coarser ones.
TEST(Decimation, NestsResults)
{
  std::mt19937_64 random(2);
  const auto results = Decimate(models::Torus(1.0, 0.3, 40, 20), { 300, 100, 40 }, true);
  ASSERT_EQ(results.size(), 3u);
  ExpectToEnclose(results[1].Mesh, results[0].Mesh, random);
  ExpectToEnclose(results[2].Mesh, results[1].Mesh, random);
}

// Surfaces that touch the mesh are tighter than nested ones.
TEST(Decimation, IsTighterWithoutNesting)
{
  const TriangleMesh torus = models::Torus(1.0, 0.3, 40, 20);
  const auto tight = Decimate(torus, { 80 }), nested = Decimate(torus, { 80 }, true);
  const auto volume = [](const DecimationResult& surface)
  { return checks::SixVolume(surface.Mesh.Points, surface.Mesh.Triangles); };
  EXPECT_LT(volume(tight[0]), volume(nested[0]));
}

// A facet with two sides is a component that cannot collapse.
TEST(Decimation, KeepsFacetsWithTwoSides)
{
  std::mt19937_64 random(6);
  TriangleMesh mesh = models::Sphere(2);
  const int first = static_cast<int>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), { { 3, 0, 0 }, { 4, 0, 0 }, { 3, 1, 0 } });
  mesh.Triangles.push_back({ first, first + 1, first + 2 });
  mesh.Triangles.push_back({ first, first + 2, first + 1 });
  const std::vector<DecimationResult> results = Decimate(mesh, { 20 });
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].Mesh.Points.size(), 20u);
  ExpectEnclosingSurface(mesh, mesh, results[0], random);
}

// A lens keeps its rim around a ring, which is far from the middle of the lens: with 40 vertices,
// the rim is at least as round as a regular polygon of 16 sides.
TEST(Decimation, KeepsShapeWhereTheSurfaceIsFar)
{
  const auto flattened = [](TriangleMesh mesh)
  {
    for (Point& p : mesh.Points)
    {
      p[2] *= 0.01;
    }
    return mesh;
  };
  const TriangleMesh lens = flattened(models::Sphere(3));
  const TriangleMesh ring = flattened(models::Torus(0.9, 0.08, 64, 8));
  Decimation decimation;
  ASSERT_EQ(DecimateEnclosing(lens, ring, {}, OptionsFor({ 40 }), decimation), "");
  const std::vector<DecimationResult> results = GetResults(decimation);
  ASSERT_EQ(results.size(), 1u);
  const double pi = std::acos(-1.0);
  for (const Point& p : results[0].Mesh.Points)
  {
    EXPECT_LE(Length(p), 1.0 / std::cos(pi / 16));
  }
}

// Parts are enclosed as well as the mesh, but errors are distances from the mesh.
TEST(Decimation, EnclosesPartsAtADistanceFromTheMesh)
{
  std::mt19937_64 random(5);
  const TriangleMesh outer = models::Sphere(3), inner = models::Moved(models::Sphere(2), {}, 0.5);
  const TriangleMesh part = models::Moved(models::Sphere(2), {}, 0.8);
  Decimation decimation;
  ASSERT_EQ(DecimateEnclosing(outer, inner, part, OptionsFor({ 30 }), decimation), "");
  ASSERT_EQ(decimation.Surfaces.size(), 1u);
  EXPECT_GE(decimation.Surfaces[0].Error, 0.3); // between the radii
  ExpectEnclosingSurface(outer, part, GetResults(decimation)[0], random);
}

// A real mesh is enclosed at a tenth of its vertices.
TEST(Decimation, EnclosesAnElephant)
{
  std::mt19937_64 random(4);
  const TriangleMesh elephant = ReadRealMesh("elephant.off");
  const auto results = Decimate(elephant, { elephant.Points.size() / 10.0 });
  ASSERT_EQ(results.size(), 1u);
  ExpectEnclosingSurface(elephant, results[0], random);
}

// The error is that of the farthest point, at most 1 % too large.
TEST(Decimation, MeasuresTheError)
{
  std::mt19937_64 random(5);
  const TriangleMesh sphere = models::Sphere(3);
  for (const DecimationResult& result : Decimate(sphere, { 300, 100, 20 }))
  {
    const double farthest = MeasureFarthest(result.Mesh, sphere, random);
    EXPECT_GE(result.Error, (1.0 - 1e-14) * farthest); // rounding
    EXPECT_LE(result.Error, 1.02 * farthest); // on a sphere, vertices are the farthest points
  }
}

// With an error bound, no point is farther, and a looser bound leaves fewer vertices.
TEST(Decimation, StaysWithinErrorBounds)
{
  std::mt19937_64 random(9);
  const TriangleMesh torus = models::Torus(1.0, 0.3, 48, 24);
  const std::vector<double> bounds = { 0.01, 0.03, 0.1 };
  const auto results = Decimate(torus, bounds, false, DecimationTarget::ErrorBound);
  ASSERT_EQ(results.size(), 3u);
  std::size_t last = torus.Points.size();
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    EXPECT_LE(MeasureFarthest(results[i].Mesh, torus, random), bounds[i]);
    EXPECT_LE(results[i].Error, bounds[i]);
    EXPECT_LT(results[i].Mesh.Points.size(), last);
    last = results[i].Mesh.Points.size();
  }
}

// A bound holds, and is said to hold, that is less than distances are accurate to: a torus that is
// long in one direction and flat in another.
TEST(Decimation, StaysWithinTinyErrorBounds)
{
  std::mt19937_64 random(10);
  TriangleMesh torus = models::Torus(1.0, 0.3, 12, 8);
  for (Point& p : torus.Points)
  {
    p = { 1e6 * p[0], p[1], 1e-6 * p[2] };
  }
  for (const double bound : { 1e-9, 0.5 })
  {
    const auto results = Decimate(torus, { bound }, false, DecimationTarget::ErrorBound);
    ASSERT_EQ(results.size(), 1u);
    EXPECT_TRUE(results[0].Reached);
    EXPECT_LE(results[0].Error, bound);
    constexpr double rounding = 1e-15 * 1e6; // of the long direction
    EXPECT_LE(MeasureFarthest(results[0].Mesh, torus, random), bound + rounding);
  }
}

// A sphere within an error bound has not many more vertices than theory asks for. A face touches
// the sphere in its center at best: an equilateral triangle with a circumradius of r reaches a
// distance of r^2 / 2 then, and n vertices have 2 n of these faces to cover the sphere.
TEST(Decimation, TakesFewVerticesWithinAnErrorBound)
{
  const TriangleMesh sphere = models::Sphere(4);
  for (const double bound : { 0.1, 0.03 })
  {
    const auto results = Decimate(sphere, { bound }, false, DecimationTarget::ErrorBound);
    ASSERT_EQ(results.size(), 1u);
    const double least = 4.0 * std::acos(-1.0) / (3.0 * std::sqrt(3.0) * bound);
    EXPECT_LE(results[0].Mesh.Points.size(), 2.5 * least) << "within " << bound;
  }
}

// Bounds hold on the way to numbers, also to one that is out of reach within its bound.
TEST(Decimation, StaysWithinBoundsOnTheWayToNumbers)
{
  const TriangleMesh torus = models::Torus(1.0, 0.3, 48, 24);
  DecimationOptions options = OptionsFor({ 400, 200, 100 });
  const auto unbounded = Decimate(torus, options);
  // The last one is too low for its number.
  options.Bounds = { unbounded[0].Error, unbounded[1].Error, unbounded[1].Error };
  const auto results = Decimate(torus, options);
  ASSERT_EQ(results.size(), 3u);
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    EXPECT_LE(results[i].Error, 1.01 * options.Bounds[i]);
    EXPECT_EQ(results[i].Reached, results[i].Mesh.Points.size() <= options.Targets[i]);
  }
  EXPECT_TRUE(results[0].Reached);
  EXPECT_FALSE(results[2].Reached);
}

// A target below what the topology allows gives the coarsest surface, marked as such.
TEST(Decimation, SaysWhereItSticks)
{
  const auto results = Decimate(models::Torus(1.0, 0.3, 16, 8), { 3 });
  ASSERT_EQ(results.size(), 1u);
  EXPECT_FALSE(results[0].Reached);
  EXPECT_GE(results[0].Mesh.Points.size(), 7u); // no torus has fewer vertices (Csaszar)
}

// A number that is far from reach may be given up. This changes nothing for a number within reach.
TEST(Decimation, GivesUpNumbersFarFromReachOnly)
{
  // No torus has fewer than seven vertices (Csaszar): all of them together keep 140.
  TriangleMesh tori;
  for (int i = 0; i < 20; ++i)
  {
    tori = models::Joined(tori, models::Moved(models::Torus(1.0, 0.3, 16, 8), { 3.0 * i, 0, 0 }));
  }
  DecimationOptions options = OptionsFor({ 800, 3 });
  const auto tried = Decimate(tori, options);
  options.GivesUp = true;
  const auto results = Decimate(tori, options);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_TRUE(results[0].Reached);
  EXPECT_EQ(results[0].Mesh.Points, tried[0].Mesh.Points);
  EXPECT_FALSE(results[1].Reached);
  EXPECT_FALSE(tried[1].Reached);
  EXPECT_GT(results[1].Mesh.Points.size(), tried[1].Mesh.Points.size());
}

// Vertices that stay name the point of the input that they are, bit for bit.
TEST(Decimation, KeepsSources)
{
  const TriangleMesh sphere = models::Sphere(2);
  const auto results = Decimate(sphere, { 1000, 100 });
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].Mesh.Points, sphere.Points); // nothing to do
  EXPECT_LT(results[0].Error, 1e-12);
  for (std::size_t i = 0; i < results[1].PointSources.size(); ++i)
  {
    const int source = results[1].PointSources[i];
    if (source >= 0)
    {
      EXPECT_EQ(results[1].Mesh.Points[i], sphere.Points[source]);
    }
  }
}

// An inward surface and separate triangles with equal points are taken as the surface that they
// are.
TEST(Decimation, AcceptsSoupsAndInwardSurfaces)
{
  std::mt19937_64 random(6);
  const TriangleMesh sphere = models::Sphere(2);
  TriangleMesh soup;
  for (const Triangle& t : sphere.Triangles)
  {
    const int first = static_cast<int>(soup.Points.size());
    for (const int corner : t)
    {
      soup.Points.push_back(sphere.Points[corner]);
    }
    soup.Triangles.push_back({ first, first + 1, first + 2 });
  }
  for (const TriangleMesh& mesh : { models::Flipped(sphere), soup })
  {
    ExpectEnclosingSurface(sphere, Decimate(mesh, { 50 })[0], random);
  }
}

// Each of several parts may be given inside out.
TEST(Decimation, AcceptsPartsThatAreInsideOut)
{
  std::mt19937_64 random(7);
  const TriangleMesh ball = models::Sphere(2), far = models::Moved(ball, { 3.0, 0.0, 0.0 });
  const TriangleMesh given = models::Joined(ball, models::Flipped(far));
  ExpectEnclosingSurface(models::Joined(ball, far), Decimate(given, { 100 })[0], random);
}

// A surface that is open, not manifold, or crosses itself is refused with the place.
TEST(Decimation, RefusesWhatIsNoClosedSurface)
{
  const auto refusal = [](const TriangleMesh& mesh)
  {
    Decimation decimation;
    return DecimateEnclosing(mesh, mesh, {}, OptionsFor({ 10 }), decimation);
  };
  EXPECT_NE(refusal(models::Sheet(2)).find("is open: 8 edges"), std::string::npos);
  TriangleMesh twisted = models::Tetrahedron();
  std::swap(twisted.Triangles[0][0], twisted.Triangles[0][1]);
  EXPECT_NE(refusal(twisted).find("not an oriented manifold: 3 edges"), std::string::npos);
  const TriangleMesh crossing =
    models::Joined(models::Box({ 0, 0, 0 }, { 2, 2, 2 }), models::Box({ 1, 1, 1 }, { 3, 3, 3 }));
  EXPECT_NE(refusal(crossing).find("crosses itself"), std::string::npos);
  EXPECT_NE(refusal({}).find("no triangle"), std::string::npos);
}
