// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Classification.h"
#include "Core/Solid/Winding.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

using namespace carving;

// A solid that fills its hull is one solid region.
TEST(Classification, FindsASolid)
{
  const Classification result = Classify(small::NestedTetrahedra(small::OuterFaces()));
  ASSERT_EQ(result.Regions.size(), 1u);
  EXPECT_EQ(result.Regions[0].Kind, RegionKind::Solid);
  EXPECT_EQ(result.Regions[0].Winding, 1.0);
  EXPECT_FALSE(result.Regions[0].Guessed);
}

// What a non-constraining face joins to the outside is complement; the solid in it is not.
TEST(Classification, TellsSolidFromOutside)
{
  const Classification result = Classify(small::NestedTetrahedra(small::InnerFaces()));
  for (int cell = 0; cell < 12; ++cell)
  {
    EXPECT_EQ(result.Kind(cell), RegionKind::Outside);
  }
  EXPECT_EQ(result.Kind(12), RegionKind::Solid);
}

// A hollow solid, its inner shell facing inward, encloses a void.
TEST(Classification, FindsAVoidInAHollowSolid)
{
  const Classification result = Classify(small::HollowTetrahedron());
  EXPECT_EQ(result.Kind(0), RegionKind::Solid);
  EXPECT_EQ(result.Kind(12), RegionKind::Void);
  EXPECT_EQ(result.Regions[result.RegionOfCell[12]].Winding, 0.0);
}

// By nonzero winding a solid within a solid is solid; so is one that is inside out.
TEST(Classification, TakesNonzeroWindingForSolid)
{
  for (const auto& outer : { small::OuterFaces(), small::Flipped(small::OuterFaces()) })
  {
    const double sign = outer == small::OuterFaces() ? 1.0 : -1.0;
    const Classification result = Classify(small::NestedTetrahedra(
      small::Joined(outer, sign > 0 ? small::InnerFaces() : small::Flipped(small::InnerFaces()))));
    EXPECT_EQ(result.Kind(0), RegionKind::Solid);
    EXPECT_EQ(result.Kind(12), RegionKind::Solid);
    EXPECT_EQ(result.Regions[result.RegionOfCell[12]].Winding, 2.0 * sign);
  }
}

// A triangle that two glued solids share faces both ways: its signed sum is 0, and crossing it
// changes nothing.
TEST(Classification, CrossesGluedFacesWithoutChange)
{
  Tetrahedralization mesh =
    small::NestedTetrahedra(small::Joined(small::OuterFaces(), small::InnerFaces()));
  for (std::size_t i = 4; i < 8; ++i)
  {
    mesh.Surface.SignedMultiplicities[i] = 0;
    mesh.Surface.Multiplicities[i] = 2;
  }
  const Classification result = Classify(mesh);
  EXPECT_EQ(result.Kind(0), RegionKind::Solid);
  EXPECT_EQ(result.Kind(12), RegionKind::Solid);
  EXPECT_EQ(result.Regions[result.RegionOfCell[12]].Winding, 1.0);
}

// A region that reaches the outside without crossing M is never solid, however deep it lies.
TEST(Classification, NeverTakesWhatReachesTheOutsideForSolid)
{
  std::vector<Triangle> cup = small::OuterFaces();
  cup.pop_back();
  const Classification result = Classify(small::NestedTetrahedra(cup));
  ASSERT_EQ(result.Regions.size(), 1u);
  EXPECT_EQ(result.Regions[0].Kind, RegionKind::Outside);
}

// Where M encloses a region but is not consistently oriented, the rule says that it has guessed.
TEST(Classification, RecordsThatItHadToGuess)
{
  std::vector<Triangle> faces = small::OuterFaces();
  std::swap(faces[1][0], faces[1][1]);
  const Classification result = Classify(small::NestedTetrahedra(faces));
  ASSERT_EQ(result.Regions.size(), 1u);
  EXPECT_TRUE(result.Regions[0].Guessed);
}

// A solid inside another one, with a triangle the wrong way round: the outer solid counts as 1, the
// inner one as the sum of its solid angles.
TEST(Classification, AddsOpenPartsToClosedOnes)
{
  std::vector<Triangle> inner = small::InnerFaces();
  std::swap(inner[1][0], inner[1][1]);
  const Tetrahedralization mesh =
    small::NestedTetrahedra(small::Joined(small::OuterFaces(), inner));
  const Classification result = Classify(mesh);
  const Region& region = result.Regions[result.RegionOfCell[12]];
  EXPECT_NEAR(region.Winding, WindingNumber(mesh.Surface, mesh.Centroid(12)), 0.02);
  EXPECT_GT(region.Winding, 1.4); // an inner triangle takes about a quarter of the full angle
  EXPECT_EQ(region.Kind, RegionKind::Solid);
  EXPECT_TRUE(region.Guessed);
}

// By even-odd, shells within shells are solid and hollow by turns, whichever way they are oriented.
TEST(Classification, AlternatesByEvenOdd)
{
  for (const auto& inner : { small::InnerFaces(), small::Flipped(small::InnerFaces()) })
  {
    const Tetrahedralization mesh =
      small::NestedTetrahedra(small::Joined(small::OuterFaces(), inner));
    const Classification result = Classify(mesh, SolidRule::EvenOdd);
    EXPECT_EQ(result.Kind(0), RegionKind::Solid);
    EXPECT_EQ(result.Kind(12), RegionKind::Void);
    EXPECT_FALSE(result.Regions[result.RegionOfCell[12]].Guessed);
  }
}

// A triangle that stands for two counts as two.
TEST(Classification, CountsMergedTrianglesByEvenOdd)
{
  Tetrahedralization mesh =
    small::NestedTetrahedra(small::Joined(small::OuterFaces(), small::InnerFaces()));
  for (std::size_t i = 4; i < 8; ++i)
  {
    mesh.Surface.Multiplicities[i] = 2;
  }
  const Classification result = Classify(mesh, SolidRule::EvenOdd);
  EXPECT_EQ(result.Kind(0), RegionKind::Solid);
  EXPECT_EQ(result.Kind(12), RegionKind::Solid);
}

// Where parity depends on the path, even-odd says that it has guessed.
TEST(Classification, RecordsThatParityDependsOnThePath)
{
  Tetrahedralization mesh = small::NestedTetrahedra(small::OuterFaces());
  mesh.Surface.Multiplicities[2] = 2;
  EXPECT_TRUE(Classify(mesh, SolidRule::EvenOdd).Regions[0].Guessed);
}

// In enclosing mode, where rays of different directions leave an open mesh through it and through
// its gap, even-odd says that it has guessed.
TEST(Classification, RecordsThatParityDependsOnTheRay)
{
  bool isEverGuessed = false, isEverCertain = false;
  for (std::size_t open = 0; open < 4; ++open)
  {
    Tetrahedralization mesh =
      small::NestedTetrahedra(small::Joined(small::OuterFaces(), small::InnerFaces()));
    mesh.Kept.assign(mesh.Cells.size(), 0);
    mesh.Kept[0] = 1;
    mesh.Unresolved = mesh.Surface;
    const Region closed = Classify(mesh, SolidRule::EvenOdd).Regions.back();
    EXPECT_FALSE(closed.Guessed);
    mesh.Unresolved.Multiplicities[open] = 2; // the same as none
    const Region region = Classify(mesh, SolidRule::EvenOdd).Regions.back();
    isEverGuessed = isEverGuessed || region.Guessed;
    isEverCertain = isEverCertain || !region.Guessed;
  }
  EXPECT_TRUE(isEverGuessed);
  EXPECT_TRUE(isEverCertain); // both rays miss some of the four sides
}

// As a surface only, a closed mesh has no solid.
TEST(Classification, FindsNoSolidInASurface)
{
  const Classification result =
    Classify(small::NestedTetrahedra(small::Joined(small::OuterFaces(), small::InnerFaces())),
      SolidRule::SurfaceOnly);
  EXPECT_EQ(result.Kind(0), RegionKind::Void);
  EXPECT_EQ(result.Kind(12), RegionKind::Void);
}
