// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Winding.h"
#include "Shapes.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

using namespace carving;
using small::Resolved;

// The winding number of a solid is 1 inside and 0 outside.
TEST(WindingNumber, IsOneInsideAndZeroOutside)
{
  const ResolvedMesh mesh = Resolved(models::Sphere(2));
  EXPECT_NEAR(WindingNumber(mesh, { 0.1, 0.2, 0.3 }), 1.0, 1e-12);
  EXPECT_NEAR(WindingNumber(mesh, { 1.1, 0.2, 0.3 }), 0.0, 1e-12);
}

// A solid that is inside out has the winding number -1 inside.
TEST(WindingNumber, IsMinusOneInsideAFlippedSolid)
{
  EXPECT_NEAR(
    WindingNumber(Resolved(models::Flipped(models::Sphere(1))), { 0.1, 0.2, 0.3 }), -1.0, 1e-12);
}

// Solids inside each other add up.
TEST(WindingNumber, AddsUpOverlappingSolids)
{
  const ResolvedMesh mesh =
    Resolved(models::Joined(models::Sphere(1), models::Moved(models::Sphere(1), {}, 2.0)));
  EXPECT_NEAR(WindingNumber(mesh, { 0.1, 0.2, 0.3 }), 2.0, 1e-12);
}

// At the center of a cube, each of its six sides takes a sixth of the full angle.
TEST(WindingNumber, OfOneSideOfACubeIsASixth)
{
  ResolvedMesh mesh = Resolved(models::Box({ -1, -1, -1 }, { 1, 1, 1 }));
  mesh.Facets.resize(2);
  EXPECT_NEAR(WindingNumber(mesh, { 0, 0, 0 }), 1.0 / 6.0, 1e-12);
}

// Merged copies count with their signed number: a two-sided leaf has no winding.
TEST(WindingNumber, UsesTheSignedNumberOfCopies)
{
  ResolvedMesh mesh = Resolved(models::Sphere(1));
  mesh.SignedMultiplicities.assign(mesh.Facets.size(), 3);
  EXPECT_NEAR(WindingNumber(mesh, { 0.1, 0.2, 0.3 }), 3.0, 1e-12);
  mesh.SignedMultiplicities.assign(mesh.Facets.size(), 0);
  EXPECT_EQ(WindingNumber(mesh, { 0.1, 0.2, 0.3 }), 0.0);
}

// A closed and consistently oriented surface is closed, whatever its genus.
TEST(IsClosed, HoldsForATorus)
{
  EXPECT_TRUE(IsClosed(Resolved(models::Torus(1.0, 0.3, 8, 5))));
}

// One triangle less, or one the wrong way round, and the surface is not closed.
TEST(IsClosed, FailsForAHoleOrAFlippedTriangle)
{
  ResolvedMesh hole = Resolved(models::Sphere(1));
  hole.Facets.pop_back();
  EXPECT_FALSE(IsClosed(hole));
  ResolvedMesh flipped = Resolved(models::Sphere(1));
  std::swap(flipped.Facets[7][0], flipped.Facets[7][1]);
  EXPECT_FALSE(IsClosed(flipped));
}

// A two-sided sheet, whose copies cancel, bounds nothing and so has no open edge.
TEST(IsClosed, HoldsForATwoSidedSheet)
{
  ResolvedMesh sheet = Resolved(models::Sheet(2));
  EXPECT_FALSE(IsClosed(sheet));
  sheet.SignedMultiplicities.assign(sheet.Facets.size(), 0);
  EXPECT_TRUE(IsClosed(sheet));
}

// Of a solid beside a sheet, the solid's facets are closed and the sheet's are not.
TEST(FindClosedParts, TellsASolidFromASheet)
{
  const auto solid = models::Sphere(1);
  const ResolvedMesh mesh =
    Resolved(models::Joined(solid, models::Moved(models::Sheet(3), { 5, 0, 0 })));
  std::vector<char> expected(mesh.Facets.size(), 0);
  std::fill_n(expected.begin(), solid.Triangles.size(), 1);
  EXPECT_EQ(FindClosedParts(mesh), expected);
}

// A leaf that grows out of a solid's edge belongs to the solid's part, which is then open. One that
// touches the solid at a vertex does not.
TEST(FindClosedParts, JoinsAcrossEdgesOnly)
{
  ResolvedMesh mesh = Resolved(models::Sphere(1));
  const auto count = mesh.Facets.size();
  const auto [a, b, c] = mesh.Facets[0];
  mesh.Points.insert(mesh.Points.end(), { { 5, 0, 0 }, { 5, 1, 0 } });
  const int added = static_cast<int>(mesh.Points.size()) - 2;
  mesh.Facets.push_back({ a, added, added + 1 });
  mesh.SignedMultiplicities.push_back(1);
  std::vector<char> expected(count + 1, 1);
  expected.back() = 0;
  EXPECT_EQ(FindClosedParts(mesh), expected);
  mesh.Facets.back() = { a, b, added };
  EXPECT_EQ(FindClosedParts(mesh), std::vector<char>(count + 1, 0));
}

// In the plane, a ring is closed, and an arc is not.
TEST(FindClosedParts, TellsARingFromAnArc)
{
  ResolvedInput<2> contours;
  contours.Points.resize(6);
  contours.Facets = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 } };
  contours.SignedMultiplicities.assign(5, 1);
  EXPECT_EQ(FindClosedParts(contours), (std::vector<char>{ 1, 1, 1, 0, 0 }));
}
