// SPDX-License-Identifier: BSD-3-Clause
#include "Helper/Exact/FindConstraints.h"

#include <gtest/gtest.h>

using namespace carving;

// A triangle that two faces have the corners of counts as lost, as one that is no face does.
TEST(FindConstraints, CountsTrianglesThatAreTwoFaces)
{
  Tetrahedralization mesh; // two cells that share a face
  mesh.Surface.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
  mesh.Cells = { { 0, 1, 2, 3 }, { 1, 2, 3, 4 } };
  mesh.Neighbors = { { 1, -1, -1, -1 }, { -1, -1, -1, 0 } };
  mesh.Surface.Facets = { { 0, 1, 2 }, { 1, 2, 3 } };
  EXPECT_EQ(helper::FindConstraints(mesh), 0u);
  mesh.Surface.Facets.push_back({ 0, 1, 4 });
  EXPECT_EQ(helper::FindConstraints(mesh), 1u);
  mesh.Surface.Facets.pop_back();
  mesh.Neighbors = { { -1, -1, -1, -1 }, { -1, -1, -1, -1 } };
  EXPECT_EQ(helper::FindConstraints(mesh), 1u); // 1, 2, 3
}
