// SPDX-License-Identifier: BSD-3-Clause
#include "Helper/Base/ExactWinding.h"
#include "Helper/Resolve/Clean.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <optional>

using namespace carving;
using namespace carving::helper;

// In front of each of nested shells are the shells around it, however close they are; a shell that
// is inside out takes one away.
TEST(ExactWinding, CountsTheShellsAround)
{
  const TriangleMesh shell = models::Sphere(2);
  const int facetsOfShell = static_cast<int>(shell.Triangles.size());
  for (const double gap : { 1e-3, 1e-8, 1e-13 })
  {
    TriangleMesh all;
    for (int i = 0; i < 4; ++i)
    {
      const TriangleMesh next = models::Moved(shell, {}, 1.0 - i * gap);
      all = models::Joined(all, i == 2 ? models::Flipped(next) : next);
    }
    const ResolvedMesh mesh = AsResolved(all);
    const ExactWinding winding(mesh);
    const int expected[] = { 0, 1, 1, 1 }; // in front of the third is what is behind the others
    for (int facet = 0; facet < static_cast<int>(mesh.Facets.size()); ++facet)
    {
      ASSERT_EQ(winding.InFrontOf(facet), expected[facet / facetsOfShell]) << gap << ' ' << facet;
    }
  }
}

// What covers a facet is not in front of it: the two sides of a sheet, and the walls of two boxes
// that touch, each of which has the other box in front.
TEST(ExactWinding, LeavesOutWhatCoversTheFacet)
{
  const TriangleMesh triangle = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const ResolvedMesh sheet = AsResolved(models::Joined(triangle, models::Flipped(triangle)));
  EXPECT_EQ(ExactWinding(sheet).InFrontOf(0), 0);
  EXPECT_EQ(ExactWinding(sheet).InFrontOf(1), 0);
  const ResolvedMesh boxes = AsResolved(
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 1, 0, 0 }, { 2, 1, 1 })));
  int touching = 0;
  for (int facet = 0; facet < static_cast<int>(boxes.Facets.size()); ++facet)
  {
    const Triangle& t = boxes.Facets[facet];
    const bool touches =
      boxes.Points[t[0]][0] == 1 && boxes.Points[t[1]][0] == 1 && boxes.Points[t[2]][0] == 1;
    touching += touches;
    EXPECT_EQ(ExactWinding(boxes).InFrontOf(facet), touches ? 1 : 0) << facet;
  }
  EXPECT_EQ(touching, 4);
}
