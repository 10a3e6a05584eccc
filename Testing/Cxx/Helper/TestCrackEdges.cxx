// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "Core/Mesh/CellGeometry.h"
#include "Core/Mesh/FacetTree.h"
#include "Core/Mesh/Validity.h"
#include "Core/Solid/Cracks.h"
#include "CrackedModels.h"
#include "Helper/Base/Kernels.h"
#include "Helper/Exact/CrackEdges.h"
#include "HelperRun.h"
#include "RandomModels.h"
#include "Resolved.h"
#include "Shapes.h"
#include "SolidVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace carving;
using namespace carving::helper;

namespace
{

/** As the helper program makes it where there is no solid whose cracks could be closed. */
Tetrahedralization Tetrahedralized(const TriangleMesh& mesh)
{
  Job job;
  job.Mesh = mesh;
  job.Conformity = Conformity::Auto;
  job.Solid = SolidRule::SurfaceOnly;
  return GetReply(job).Result;
}

double VolumeOfCells(const Tetrahedralization& mesh)
{
  double volume = 0.0;
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    volume += Size(CornersOfCell(mesh, cell));
  }
  return volume;
}

/** Exact. */
int CountNotPositive(const Tetrahedralization& mesh)
{
  int count = 0;
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.size()); ++cell)
  {
    const auto [a, b, c, d] = CornersOfCell(mesh, cell);
    count +=
      CGAL::orientation(ToInexact(a), ToInexact(b), ToInexact(c), ToInexact(d)) != CGAL::POSITIVE;
  }
  return count;
}

int SplitEdges(const Tetrahedralization& mesh, Tetrahedralization& split)
{
  return SplitEdgesThroughCracks(mesh, MostCrackWidth * Diagonal(mesh.Surface), split).Points;
}

double VolumeOf(const TriangleMesh& mesh)
{
  return checks::SixVolume(mesh.Points, mesh.Triangles) / 6.0;
}

/** Expects that a mesh with cracks has the solid that it winds around. */
void ExpectSolid(const TriangleMesh& mesh, double volume)
{
  Job job;
  job.Mesh = mesh;
  job.Conformity = Conformity::Auto;
  job.Solid = SolidRule::NonzeroWinding;
  job.EnclosingTolerance = 0.02;
  job.SnapTolerance = 1e-12;
  Tetrahedralization result = GetReply(job).Result;
  EXPECT_EQ(FindMistake(result), "");
  SealCracks(result, SolidRule::NonzeroWinding, 1);
  const double tolerance = result.Kept.empty() ? 1e-4 : 0.3; // enclosed where TetGen fails
  EXPECT_NEAR(VolumeOfSolid(result, Classify(result)), volume, tolerance);
}

} // namespace

// Where a part of a torus has been moved by less than the width of a crack, the solid is closed.
TEST(CrackEdges, MakeRoomForSeals)
{
  std::mt19937_64 random(1);
  for (int i = 0; i < 12; ++i)
  {
    SCOPED_TRACE("torus " + std::to_string(i));
    ExpectSolid(models::TorusInTwoParts(
                  std::array{ 1e-9, 1e-7, 4e-7 }[i % 3], i % 2 == 0 ? 0.0 : 0.1, random),
      VolumeOf(models::Torus(1.0, 0.4, 12, 8)));
  }
}

// Vertices that hang on edges of larger triangles do not open the solid.
TEST(CrackEdges, CloseSolidsWithHangingNodes)
{
  std::mt19937_64 random(4);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_MESHES", 12);
  for (int i = 0; i < count; ++i)
  {
    SCOPED_TRACE("solid " + std::to_string(i));
    const TriangleMesh solid = i % 3 == 0 ? models::Box({ 0, 0, 0 }, { 3, 2, 1 })
      : i % 3 == 1                        ? models::Sphere(1)
                                          : models::Torus(1.0, 0.4, 12, 8);
    ExpectSolid(models::WithHangingNodes(solid, 1 + i / 3 % 2, random), VolumeOf(solid));
  }
}

// Neither do corners of rectangles that lie on sides of others, where edges of several triangles
// pass each other.
TEST(CrackEdges, CloseVoxelsOfLargeRectangles)
{
  std::mt19937_64 random(5);
  const int count = models::NumberOfCases("TOPOLOGYCARVING_RANDOM_MESHES", 12);
  for (int i = 0; i < count; ++i)
  {
    SCOPED_TRACE("voxels " + std::to_string(i));
    const models::Voxels voxels = models::RandomVoxels(2 + i % 3, 0.4, random);
    ExpectSolid(voxels.Surface, voxels.Count);
  }
}

// Split tetrahedra fill the same space, positively oriented, and M has the same area.
TEST(CrackEdges, KeepTheMeshValid)
{
  std::mt19937_64 random(2);
  int added = 0;
  std::size_t facets = 0;
  for (int i = 0; i < 12; ++i)
  {
    const Tetrahedralization mesh =
      Tetrahedralized(i % 2 ? models::TorusInTwoParts(1e-7, 0.1, random)
                            : models::RandomVoxels(3, 0.4, random).Surface);
    Tetrahedralization split;
    const int points = SplitEdges(mesh, split);
    if (points == 0)
    {
      continue;
    }
    added += points;
    facets += split.Surface.Facets.size() - mesh.Surface.Facets.size();
    EXPECT_EQ(FindMistake(split), "");
    EXPECT_EQ(CountNotPositive(split), 0);
    EXPECT_NEAR(VolumeOfCells(split), VolumeOfCells(mesh), 1e-12);
    EXPECT_EQ(split.Surface.Points.size(), mesh.Surface.Points.size() + points);
    EXPECT_NEAR(AreaOf(split.Surface), AreaOf(mesh.Surface), 1e-12);
    const std::vector<int> faces = checks::CountFaces(split);
    EXPECT_EQ(std::count(faces.begin(), faces.end(), 0), 0);
    if (split.Surface.Facets.size() == mesh.Surface.Facets.size()) // no edge of M was split
    {
      EXPECT_EQ(split.Surface.Facets, mesh.Surface.Facets);
      EXPECT_EQ(faces, checks::CountFaces(mesh));
    }
  }
  EXPECT_GT(added, 0);
  EXPECT_GT(facets, 0u); // of M, where its edges pass each other
}

// Nothing is split where there is no crack: closed, open, or with a slit that is wider.
TEST(CrackEdges, AreOnlyThoseOfCracks)
{
  std::mt19937_64 random(3);
  TriangleMesh bowl = models::Torus(1.0, 0.4, 12, 8);
  bowl.Triangles.resize(bowl.Triangles.size() / 2);
  for (const TriangleMesh& mesh :
    { models::Torus(1.0, 0.4, 12, 8), bowl, models::TorusInTwoParts(1e-2, 0.1, random) })
  {
    Tetrahedralization split;
    EXPECT_EQ(SplitEdges(Tetrahedralized(mesh), split), 0);
  }
}
