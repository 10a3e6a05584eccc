// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Enclosing mode: the distance of the last level from the mesh.
 */
#include "Blocks.h"
#include "Checks.h"
#include "Core/Mesh/Box.h"
#include "Core/Mesh/Vector.h"
#include "Helper/Enclosing/Refine.h"
#include "Helper/Resolve/Clean.h"
#include "HelperRun.h"
#include "RandomModels.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace carving;
using namespace carving::helper;

namespace
{

/** The largest distance from a mesh of sample points on the exposed faces of kept tetrahedra. */
double SampleReach(const TriangleMesh& mesh, const Tetrahedralization& result)
{
  const std::vector<Point>& points = result.Surface.Points;
  double farthest = 0.0;
  for (std::size_t cell = 0; cell < result.Cells.size(); ++cell)
  {
    for (int f = 0; f < 4 && result.Kept[cell]; ++f)
    {
      const int other = result.Neighbors[cell][f];
      if (other >= 0 && result.Kept[other])
      {
        continue;
      }
      const auto [a, b, c] = result.OutwardFace(static_cast<int>(cell), f);
      for (const auto& [u, v] : { std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(0.0, 1.0),
             std::pair(0.5, 0.0), std::pair(0.0, 0.5), std::pair(0.5, 0.5), std::pair(0.33, 0.33) })
      {
        const Point p = (1.0 - u - v) * points[a] + u * points[b] + v * points[c];
        farthest = std::max(farthest, checks::DistanceTo(mesh.Points, mesh.Triangles, p));
      }
    }
  }
  return farthest;
}

} // namespace

// Kept tetrahedra are within the tolerance, and the reported distance is correct.
TEST(Refine, ReachesTheTolerance)
{
  std::mt19937_64 random(11);
  for (int i = 0; i < 12; ++i)
  {
    SCOPED_TRACE("soup " + std::to_string(i));
    const TriangleMesh mesh = models::Soup(4 + static_cast<int>(random() % 20), random);
    const double tolerance = std::array{ 0.03, 0.06, 0.12 }[random() % 3];
    const Reply reply = GetReply(mesh, Conformity::Enclosing, tolerance);
    EXPECT_LE(reply.KeptDistance, 1.05 * tolerance * Diagonal(mesh.Points));
    EXPECT_LE(SampleReach(mesh, reply.Result), 1.05 * reply.KeptDistance);
  }
}

// A smaller tolerance adds more vertices; the tolerance 0 adds none.
TEST(Refine, AddsVerticesOnlyIfTold)
{
  std::mt19937_64 random(12);
  const TriangleMesh mesh = models::Soup(10, random);
  int last = 0;
  for (const double tolerance : { 0.0, 0.1, 0.02 })
  {
    const Reply reply = GetReply(mesh, Conformity::Enclosing, tolerance);
    const ResolvedMesh& surface = reply.Result.Surface;
    EXPECT_EQ(
      std::count(surface.PointSources.begin(), surface.PointSources.end(), -1), reply.PointsAdded);
    if (tolerance == 0.0)
    {
      EXPECT_EQ(reply.PointsAdded, 0);
      EXPECT_LE(SampleReach(mesh, reply.Result), 1.05 * reply.KeptDistance);
      EXPECT_GT(reply.KeptDistance, 0.02 * Diagonal(mesh.Points));
    }
    else
    {
      EXPECT_GT(reply.PointsAdded, last);
    }
    last = reply.PointsAdded;
  }
}

// A mesh all of whose triangles are Delaunay faces gets no further vertex.
TEST(Refine, AddsNothingToADelaunayMesh)
{
  const Reply reply = GetReply(
    models::Joined(models::Box({ 0, 0, 0 }, { 1, 1, 1 }), models::Box({ 3, 0, 0 }, { 4, 1, 1 })),
    Conformity::Enclosing, 0.001);
  EXPECT_EQ(reply.PointsAdded, 0);
  EXPECT_EQ(reply.KeptDistance, 0.0);
}

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

// Finely tessellated walls that touch in parts of their sides are enclosed.
TEST(Refine, EnclosesFlatWalls)
{
  const TriangleMesh mesh = models::Blocks(4);
  const Reply reply = GetReply(mesh, Conformity::Enclosing);
  EXPECT_EQ(reply.Error, "");
  EXPECT_LE(SampleReach(mesh, reply.Result), 1.05 * reply.KeptDistance);
}
