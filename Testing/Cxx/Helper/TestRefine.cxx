// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Points that are added to a Delaunay tetrahedralization around a mesh.
 */
#include "Blocks.h"
#include "Core/Mesh/Box.h"
#include "Helper/Enclosing/ExposedFaces.h"
#include "Helper/Enclosing/Refine.h"
#include "Helper/Resolve/Clean.h"
#include "HelperRun.h"
#include "RandomModels.h"

#include <gtest/gtest.h>

#include <random>

using namespace carving;
using namespace carving::helper;

namespace
{

bool Proceed(double)
{
  return true;
}

} // namespace

// Refining brings the surface of pierced tetrahedra within the tolerance of the mesh.
TEST(Refine, ReachesTheTolerance)
{
  std::mt19937_64 random(11);
  for (int i = 0; i < 12; ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    const ResolvedMesh input =
      Clean(AsResolved(models::Soup(4 + static_cast<int>(random() % 20), random)));
    const double length = Diagonal(input.Points);
    const double tolerance = std::array{ 0.03, 0.06, 0.12 }[random() % 3] * length;
    PiercedMesh mesh(input, {}, Proceed);
    const SurfaceDistance distance(input);
    Refine(mesh, distance, tolerance, 1000000, Proceed);
    EXPECT_LE(MeasureKept(mesh, distance, 1e-4 * length, length).Maximum, 1.05 * tolerance);
  }
}

// The work is in proportion to the mesh and the points added, however many parts pierce a cell.
TEST(Refine, EndsOnFlatWallsThatAreOffTheirPlane)
{
  const ResolvedMesh input = Clean(AsResolved(models::Blocks(12)));
  PiercedMesh mesh(input, {}, Proceed);
  const std::size_t points = input.Points.size(), before = mesh.GetEffort();
  Refine(mesh, SurfaceDistance(input), 5e-3 * Diagonal(input.Points), 100 * points, Proceed);
  const std::size_t added = mesh.GetParts().GetPoints().size() - points;
  const double most = 1e7 + 2e3 * static_cast<double>(added);
  // The last point may pass the limit.
  EXPECT_LT(static_cast<double>(mesh.GetEffort() - before), 1.5 * most);
}
