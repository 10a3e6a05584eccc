// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/FacetTree.h"
#include "Helper/Exact/Tetrahedralize.h"
#include "Helper/Resolve/Interior.h"
#include "HelperRun.h"
#include "RandomModels.h"
#include "Resolved.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

using namespace carving;
using namespace carving::helper;

namespace
{

/** The triangles that bound the solid, by coordinates, with the solid behind them. */
std::set<std::array<Point, 3>> BoundaryOfSolid(const ResolvedMesh& surface, SolidRule rule)
{
  Tetrahedralization mesh;
  mesh.Surface = surface;
  EXPECT_EQ(Tetrahedralize({}, SurfacePoints::None, mesh).Mistake, "");
  const Classification regions = Classify(mesh, rule);
  std::set<std::array<Point, 3>> boundary;
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    for (int f = 0; f < 4; ++f)
    {
      const int other = mesh.Neighbors[cell][f];
      if (regions.Kind(cell) == RegionKind::Solid &&
        (other < 0 || regions.Kind(other) != RegionKind::Solid))
      {
        auto corners = CornersOf<3>(mesh.Surface.Points, mesh.OutwardFace(cell, f));
        std::rotate(
          corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        boundary.insert(corners);
      }
    }
  }
  return boundary;
}

TriangleMesh OverlappingBoxes()
{
  return models::Joined(
    models::Box({ 0, 0, 0 }, { 2, 2, 2 }), models::Box({ 1, 1, 1 }, { 3, 3, 3 }));
}

} // namespace

// The walls inside two overlapping boxes are dropped by the nonzero rule only.
TEST(Interior, HasSolidOnBothSides)
{
  const ResolvedMesh whole = Resolved(OverlappingBoxes());
  ResolvedMesh mesh = whole;
  EXPECT_GT(DropInterior(SolidRule::NonzeroWinding, mesh), 0);
  EXPECT_LT(mesh.Facets.size(), whole.Facets.size());
  EXPECT_EQ(
    mesh.Points.size(), 7u + 7u + 6u); // each box loses a corner; edges cross sides at six points
  for (const SolidRule rule : { SolidRule::EvenOdd, SolidRule::SurfaceOnly })
  {
    mesh = whole;
    EXPECT_EQ(DropInterior(rule, mesh), 0);
    EXPECT_EQ(mesh.Facets, whole.Facets);
  }
}

// The solid of overlapping, nested, glued and inverted boxes is unchanged, by every rule.
TEST(Interior, LeavesTheSolidAsItIs)
{
  std::mt19937_64 random(1);
  int dropped = 0, compared = 0;
  for (int i = 0; i < 60; ++i)
  {
    const ResolvedMesh whole = Resolved(models::BoxSoup(3 + i % 4, random));
    for (const SolidRule rule : { SolidRule::NonzeroWinding, SolidRule::EvenOdd })
    {
      ResolvedMesh mesh = whole;
      const int count = DropInterior(rule, mesh);
      if (count == 0)
      {
        EXPECT_EQ(mesh.SignedMultiplicities, whole.SignedMultiplicities);
        continue;
      }
      EXPECT_EQ(mesh.Facets.size() + count, whole.Facets.size());
      dropped += count;
      ++compared;
      EXPECT_EQ(BoundaryOfSolid(mesh, rule), BoundaryOfSolid(whole, rule));
    }
  }
  EXPECT_GT(compared, 20);
  EXPECT_GT(dropped, 100);
}

// Walls that are very close to each other stay: only the overlap of two other boxes is dropped.
TEST(Interior, LeavesWallsCloseToEachOther)
{
  for (const double gap : { 1e-4, 1e-8, 1e-12 })
  {
    const TriangleMesh left = models::Box({ 10, 0, 0 }, { 13, 2, 3 }),
                       right = models::Box({ 13 + gap, 0, 0 }, { 16, 2, 3 });
    for (const TriangleMesh& close :
      { models::Joined(left, right), models::Joined(models::Flipped(left), right) })
    {
      const ResolvedMesh whole = Resolved(models::Joined(close, OverlappingBoxes()));
      ResolvedMesh mesh = whole;
      EXPECT_GT(DropInterior(SolidRule::NonzeroWinding, mesh), 0);
      EXPECT_EQ(BoundaryOfSolid(mesh, SolidRule::NonzeroWinding),
        BoundaryOfSolid(whole, SolidRule::NonzeroWinding));
    }
  }
}

// An open mesh is unchanged.
TEST(Interior, IsUnknownOfOpenMeshes)
{
  TriangleMesh open = OverlappingBoxes();
  open.Triangles.pop_back();
  const ResolvedMesh given = Resolved(open);
  ResolvedMesh mesh = given;
  EXPECT_EQ(DropInterior(SolidRule::NonzeroWinding, mesh), 0);
  EXPECT_EQ(mesh.Facets, given.Facets);
}

// Where TetGen fails on the whole mesh, the next attempt is without the interior of the solid.
TEST(Interior, IsDroppedWhereTetGenFailsOnTheWhole)
{
  std::mt19937_64 random(2);
  Job job;
  job.Mesh = models::Assembly(12, random);
  job.Solid = SolidRule::NonzeroWinding;
  const Reply reply = GetReply(job);
  EXPECT_EQ(reply.Strategy.find("TetGen -pcY, without interior"), 0u) << reply.Strategy;
  EXPECT_GT(reply.InteriorDropped, 0);
  EXPECT_NE(reply.SolidMatters, 0);
}
