// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decompositions without the cells of the solid.
 */
#include "Core/Measure/StreamTopology.h"
#include "Core/Mesh/Validity.h"
#include "Core/Solid/DropSolid.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <utility>

using namespace carving;

namespace
{

/** Nothing, a solid, a solid in a shell, a full hull, and a hollow solid. */
std::vector<Tetrahedralization> Meshes()
{
  const auto inner = small::InnerFaces();
  return { small::Row(6), small::NestedTetrahedra(inner),
    small::NestedTetrahedra(small::Joined(inner, small::Flipped(small::OuterFaces()))),
    small::NestedTetrahedra(small::OuterFaces()), small::HollowTetrahedron() };
}

} // namespace

// The cells around a solid remain, in their order; each facet knows the solid behind it.
TEST(DropSolid, LeavesTheComplement)
{
  const Tetrahedralization whole = small::NestedTetrahedra(small::InnerFaces());
  Tetrahedralization mesh = whole;
  Classification regions = Classify(mesh);
  const int solid = regions.RegionOfCell[12];
  DropSolid(mesh, regions);
  ASSERT_EQ(mesh.Cells.size(), 12u);
  EXPECT_EQ(mesh.Cells, (decltype(mesh.Cells){ whole.Cells.begin(), whole.Cells.begin() + 12 }));
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int before = whole.Neighbors[cell][f];
      EXPECT_EQ(mesh.Neighbors[cell][f], before == 12 ? Solid : before);
    }
  }
  const std::array<int, 2> behind = { solid, -1 };
  EXPECT_EQ(regions.SolidRegions, (std::vector<std::array<int, 2>>(4, behind)));
}

// Carving without the cells of the solid gives the same stream with the same topology.
TEST(DropSolid, ChangesNoStream)
{
  for (const Tetrahedralization& whole : Meshes())
  {
    for (const SolidRule rule : { SolidRule::NonzeroWinding, SolidRule::SurfaceOnly })
    {
      Classification regions = Classify(whole, rule);
      Stream order;
      ASSERT_TRUE(Carve(whole, regions, {}, order, {}));
      const StoredStream<3> expected = Store(whole, regions, order);
      const StreamTopology topology = ComputeTopology(whole, regions, order);
      Tetrahedralization mesh = whole;
      DropSolid(mesh, regions);
      ASSERT_TRUE(Carve(mesh, regions, {}, order, {}));
      const StoredStream<3> found = Store(std::move(mesh), regions, std::move(order));
      EXPECT_EQ(found.Mesh.Cells, expected.Mesh.Cells);
      EXPECT_EQ(found.Mesh.Neighbors, expected.Mesh.Neighbors);
      EXPECT_EQ(found.Mesh.Constraints, expected.Mesh.Constraints);
      EXPECT_EQ(found.Order.Step, expected.Order.Step);
      EXPECT_EQ(found.Regions, expected.Regions);
      EXPECT_EQ(found.Sides, expected.Sides);
      const StreamTopology same = ComputeTopology(found.Mesh, regions, found.Order);
      EXPECT_EQ(same.Components, topology.Components);
      EXPECT_EQ(same.Tunnels, topology.Tunnels);
      EXPECT_EQ(same.Voids, topology.Voids);
    }
  }
}

// A mesh without its solid is valid with the regions of the solid, but not if these differ at the
// faces of its cells.
TEST(DropSolid, LeavesAValidMesh)
{
  for (Tetrahedralization mesh : Meshes())
  {
    Classification regions = Classify(mesh);
    DropSolid(mesh, regions);
    EXPECT_EQ(FindMistake(mesh, regions.SolidRegions), "");
    std::vector<char> isFace(mesh.Surface.Facets.size(), 0);
    for (const int facet : mesh.Constraints.OfFaces)
    {
      isFace[facet] = 1;
    }
    for (std::size_t facet = 0; facet < isFace.size(); ++facet)
    {
      for (int side = 0; side < 2; ++side)
      {
        auto wrong = regions.SolidRegions;
        wrong[facet][side] = wrong[facet][side] < 0 ? 0 : -1;
        const bool isInSolid = wrong[facet][0] >= 0 || wrong[facet][1] >= 0;
        EXPECT_EQ(FindMistake(mesh, wrong).empty(), isInSolid && !isFace[facet]) << facet;
      }
    }
    auto more = regions.SolidRegions;
    more.push_back({ 0, 0 });
    EXPECT_NE(FindMistake(mesh, more), "");
  }
}
