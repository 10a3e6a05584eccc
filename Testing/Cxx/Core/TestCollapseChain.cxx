// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stream/CollapseChain.h"

#include <gtest/gtest.h>

using namespace carving;

namespace
{

/** An octahedron of which the edge between points 0 and 1 collapses into point 6. */
CollapseChain MakeChain()
{
  // 0 and 1 are on the equator beside each other, 2 and 3 follow, 4 and 5 are the poles.
  return { 6, 8, 1,
    { { { 0, 1, 4 }, 0, 0, 1 }, { { 1, 2, 4 }, 1, 0, 1 }, { { 2, 3, 4 }, 2, 0, 2 },
      { { 3, 0, 4 }, 3, 0, 1 }, { { 1, 0, 5 }, 4, 0, 1 }, { { 2, 1, 5 }, 5, 0, 1 },
      { { 3, 2, 5 }, 6, 0, 2 }, { { 0, 3, 5 }, 7, 0, 1 }, { { 6, 2, 4 }, 1, 1, 2 },
      { { 3, 6, 4 }, 3, 1, 2 }, { { 2, 6, 5 }, 5, 1, 2 }, { { 6, 3, 5 }, 7, 1, 2 } } };
}

} // namespace

// After each collapse, the surface has the triangles alive, and their points alone.
TEST(CollapseChain, ExtractsSurfaces)
{
  const CollapseChain chain = MakeChain();
  EXPECT_EQ(FindMistake(chain, 7), "");
  const CollapsedSurface before = ExtractSurface(chain, 0);
  EXPECT_EQ(before.Points, (std::vector<int>{ 0, 1, 2, 3, 4, 5 }));
  EXPECT_EQ(before.Sources, (std::vector<int>{ 0, 1, 2, 3, 4, 5, 6, 7 }));
  const CollapsedSurface after = ExtractSurface(chain, 1);
  EXPECT_EQ(after.Points, (std::vector<int>{ 2, 3, 4, 5, 6 }));
  EXPECT_EQ(after.Sources, (std::vector<int>{ 2, 6, 1, 3, 5, 7 }));
  EXPECT_EQ(after.Triangles[2], (Triangle{ 4, 0, 2 })); // 6, 2, 4
}

// A number of collapses that would take ages to check is refused at once.
TEST(CollapseChain, RefusesImpossibleNumbers)
{
  CollapseChain chain = MakeChain();
  chain.Vertices = chain.Triangles = 2000000000;
  chain.Collapses = 900000000;
  EXPECT_NE(FindMistake(chain, 7), "");
}
