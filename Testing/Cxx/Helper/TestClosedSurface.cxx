// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Orientation of closed surfaces.
 */
#include "Core/Mesh/Vector.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Decimation/ClosedSurface.h"
#include "Helper/Resolve/Clean.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace carving;

namespace
{

/** Four points that are in one plane up to rounding, in positive order; in any plane. */
TriangleMesh FlatTetrahedron(std::mt19937_64& random)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto draw = [&] { return Point{ uniform(random), uniform(random), uniform(random) }; };
  const Point origin = draw(), u = draw(), v = draw();
  TriangleMesh mesh;
  for (int i = 0; i < 4; ++i)
  {
    mesh.Points.push_back(origin + uniform(random) * u + uniform(random) * v);
  }
  const auto at = [&mesh](int i) { return helper::ToInexact(mesh.Points[i]); };
  if (CGAL::orientation(at(0), at(1), at(2), at(3)) == CGAL::NEGATIVE)
  {
    std::swap(mesh.Points[0], mesh.Points[1]);
  }
  mesh.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  return mesh;
}

} // namespace

// The orientation of a solid is found exactly, however flat the solid is.
TEST(ClosedSurface, KeepsTheOrientationOfFlatSolids)
{
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i)
  {
    SCOPED_TRACE(i);
    const TriangleMesh mesh = FlatTetrahedron(random);
    for (const TriangleMesh& given : { mesh, models::Flipped(mesh) })
    {
      ResolvedMesh surface = helper::AsResolved(given);
      const std::string mistake = helper::MakeClosedSurface(surface);
      EXPECT_TRUE(!mistake.empty() || surface.Facets == mesh.Triangles) << mistake;
    }
  }
}

// Parts that are inside out are turned: a ball, and a ball with a cavity. Others are kept.
TEST(ClosedSurface, TurnsPartsOutward)
{
  const TriangleMesh ball = models::Moved(models::Sphere(1), { 5.0, 0.0, 0.0 });
  const TriangleMesh hollow =
    models::Joined(models::Sphere(1), models::Flipped(models::Moved(models::Sphere(1), {}, 0.5)));
  const TriangleMesh right = models::Joined(ball, hollow);
  for (const TriangleMesh& given : { right, models::Joined(models::Flipped(ball), hollow),
         models::Joined(ball, models::Flipped(hollow)), models::Flipped(right) })
  {
    ResolvedMesh surface = helper::AsResolved(given);
    ASSERT_EQ(helper::MakeClosedSurface(surface), "");
    helper::TurnPartsOutward(surface);
    const auto normalsOf = [](const std::vector<Point>& points, const std::vector<Triangle>& faces)
    {
      std::vector<Point> normals;
      for (const auto& [a, b, c] : faces)
      {
        normals.push_back(Cross(points[b] - points[a], points[c] - points[a]));
      }
      return normals;
    };
    const std::vector<Point> turned = normalsOf(surface.Points, surface.Facets),
                             expected = normalsOf(right.Points, right.Triangles);
    ASSERT_EQ(turned.size(), expected.size());
    for (std::size_t i = 0; i < turned.size(); ++i)
    {
      EXPECT_GT(Dot(turned[i], expected[i]), 0.0) << i;
    }
  }
}
