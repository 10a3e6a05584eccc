// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Recovery/FlatParts.h"
#include "Helper/Recovery/RecoverAll.h"
#include "Helper/Resolve/Clean.h"
#include "RandomModels.h"
#include "Resolved.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

using namespace carving;
using namespace carving::helper;

namespace
{

/** A flat ring of square cross-section. */
TriangleMesh Washer(int sides)
{
  TriangleMesh mesh;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / sides;
    for (const auto& [radius, z] :
      { std::pair(1.0, 0.0), { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 } })
    {
      mesh.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle), z });
    }
    for (int k = 0; k < 4; ++k)
    {
      const int next = (i + 1) % sides, other = (k + 1) % 4;
      const int a = 4 * i + k, b = 4 * next + k, c = 4 * next + other, d = 4 * i + other;
      mesh.Triangles.push_back({ a, b, c });
      mesh.Triangles.push_back({ a, c, d });
    }
  }
  return mesh;
}

RetriangulatedMesh Adopt(const ResolvedMesh& mesh)
{
  return AdoptDelaunayFaces(mesh, {}, 1e-12 * Diagonal(mesh.Points));
}

} // namespace

// The ends of rotated prisms, whose corners are on a circle but for rounding, get other triangles
// of the same corners, within the tolerance. The prisms are then met in little time.
TEST(FlatParts, OfPrismsAreRecoveredAtOnce)
{
  std::mt19937_64 random(1);
  int changed = 0;
  for (int i = 0; i < 10; ++i)
  {
    SCOPED_TRACE("prism " + std::to_string(i));
    const int sides = 3 + static_cast<int>(random() % 100);
    const TriangleMesh prism = models::Rotated(models::Prism(sides, 0.0, 2.0), random);
    const ResolvedMesh given = Clean(AsResolved(prism));
    const RetriangulatedMesh adopted = Adopt(given);
    if (adopted.Changed == 0)
    {
      continue;
    }
    changed += adopted.Changed;
    EXPECT_LE(adopted.Distance, 1e-12 * Diagonal(given.Points));
    EXPECT_EQ(adopted.Mesh.Points, given.Points);
    EXPECT_EQ(adopted.Mesh.Facets.size(), given.Facets.size());
    EXPECT_NEAR(AreaOf(adopted.Mesh), AreaOf(given), 1e-12);
    EXPECT_TRUE(checks::IsClosed(adopted.Mesh.Facets));
    Tetrahedralization result;
    result.Surface = adopted.Mesh;
    const auto goOn = [](double) { return true; };
    EXPECT_EQ(RecoverAll({}, RecoveryEffort::Little, 1, goOn, result).Mistake, "");
  }
  EXPECT_GT(changed, 0);
}

// Each new triangle takes over the source of an old one in the same plane.
TEST(FlatParts, KeepTheirSources)
{
  std::mt19937_64 random(2);
  const ResolvedMesh given =
    Clean(AsResolved(models::Rotated(models::Prism(60, 0.0, 2.0), random)));
  const RetriangulatedMesh adopted = Adopt(given);
  ASSERT_GT(adopted.Changed, 0);
  const auto normalOf = [&](const Triangle& t)
  {
    const auto [a, b, c] = carving::CornersOf<3>(given.Points, t);
    const Point normal = Cross(b - a, c - a);
    return normal / Length(normal);
  };
  for (std::size_t i = 0; i < adopted.Mesh.Facets.size(); ++i)
  {
    const Triangle& source = given.Facets[adopted.Mesh.FacetSources[i]];
    EXPECT_GT(Dot(normalOf(adopted.Mesh.Facets[i]), normalOf(source)), 1.0 - 1e-9) << i;
  }
}

// A mesh without flat parts stays as it is, and so do parts of triangles that the Delaunay
// tetrahedralization has.
TEST(FlatParts, StayWhereNothingIsToBeGained)
{
  EXPECT_EQ(Adopt(Clean(AsResolved(models::Sphere(2)))).Changed, 0);
  EXPECT_EQ(Adopt(Clean(AsResolved(models::Tetrahedron()))).Changed, 0);
  std::mt19937_64 random(4);
  const RetriangulatedMesh adopted =
    Adopt(Clean(AsResolved(models::Rotated(models::Prism(60, 0.0, 2.0), random))));
  ASSERT_GT(adopted.Changed, 0);
  EXPECT_EQ(Adopt(adopted.Mesh).Changed, 0);
}

// Flat parts that are not convex, or have a hole, keep their borders.
TEST(FlatParts, KeepTheirBorders)
{
  std::mt19937_64 random(3);
  int changed = 0;
  for (int i = 0; i < 10; ++i)
  {
    const ResolvedMesh given = Clean(AsResolved(models::Rotated(Washer(40), random)));
    const RetriangulatedMesh adopted = Adopt(given);
    changed += adopted.Changed;
    if (adopted.Changed > 0)
    {
      EXPECT_TRUE(checks::IsClosed(adopted.Mesh.Facets));
      EXPECT_NEAR(AreaOf(adopted.Mesh), AreaOf(given), 1e-12);
    }
  }
  EXPECT_GT(changed, 0);
}

// A closed part whose neighboring triangles are all flat within the tolerance stays: its border is
// that of no triangles, too.
TEST(FlatParts, DoNotVanishWithoutABorder)
{
  const ResolvedMesh given = Clean(AsResolved(
    models::Joined(models::Sphere(1), models::Moved(models::Sphere(4), { 3, 0, 0 }, 0.01))));
  EXPECT_EQ(AdoptDelaunayFaces(given, {}, 1e-3 * Diagonal(given.Points)).Changed, 0);
}
