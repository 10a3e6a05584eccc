// SPDX-License-Identifier: BSD-3-Clause
#include "Helper/Exact/Hull.h"
#include "HelperRun.h"
#include "Shapes.h"

#include <gtest/gtest.h>

using namespace carving;
using namespace carving::helper;

// All tetrahedra fill the hull; with one missing or duplicated they do not.
TEST(Hull, IsFilledByAllTetrahedra)
{
  Tetrahedralization mesh =
    GetReply(models::Joined(models::Sphere(3), models::Box({ 2, 0, 0 }, { 3, 1, 1 }))).Result;
  EXPECT_TRUE(FillsHull(mesh));
  const auto last = mesh.Cells.back();
  const auto neighborsOfLast = mesh.Neighbors.back();
  mesh.Cells.pop_back();
  mesh.Neighbors.pop_back();
  EXPECT_FALSE(FillsHull(mesh));
  mesh.Cells.insert(mesh.Cells.end(), 2, last);
  mesh.Neighbors.insert(mesh.Neighbors.end(), 2, neighborsOfLast);
  EXPECT_FALSE(FillsHull(mesh));
}
