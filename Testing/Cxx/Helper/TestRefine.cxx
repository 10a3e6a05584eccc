// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Points that are added to a Delaunay tetrahedralization around a mesh.
 */
#include "Blocks.h"
#include "Core/Mesh/Box.h"
#include "Helper/Enclosing/Refine.h"
#include "Helper/Resolve/Clean.h"
#include "HelperRun.h"

#include <gtest/gtest.h>

using namespace carving;
using namespace carving::helper;

// The work is in proportion to the mesh and the points added, however many parts pierce a cell.
TEST(Refine, EndsOnFlatWallsThatAreOffTheirPlane)
{
  const ResolvedMesh input = Clean(AsResolved(models::Blocks(12)));
  PiercedMesh mesh(input, {}, [](double) { return true; });
  const std::size_t points = input.Points.size(), before = mesh.GetEffort();
  Refine(mesh, SurfaceDistance(input), 5e-3 * Diagonal(input.Points), 100 * points,
    [](double) { return true; });
  const std::size_t added = mesh.GetParts().GetPoints().size() - points;
  const double most = 1e7 + 2e3 * static_cast<double>(added);
  // The last point may pass the limit.
  EXPECT_LT(static_cast<double>(mesh.GetEffort() - before), 1.5 * most);
}
